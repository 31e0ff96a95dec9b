#include "apps/terrane-accuracy/TeTerrainChoice.h"

#include "apps/terrane-accuracy/TeSmoothLand.h"

void TeTerrainChoice::addTo(CLI::App& command) {
  const std::string group = "Terrain";
  CLI::Option* file =
      command
          .add_option("--map", map,
                      "2^n + 1 samples a side of 16 bits, little-endian, the first row in the "
                      "south, no header")
          ->check(TeCommandLine::notEmpty())
          ->option_text("FILE.raw")
          ->group(group);
  command.add_option("--cells", cells, "Metres between its samples (default: 10)")
      ->check(TeCommandLine::within(1e-3, 1e6))
      ->option_text("METRES")
      ->needs(file)
      ->group(group);
  command.add_option("--height-unit", heightUnit, "Metres of one step of its heights (default: 0.03)")
      ->check(TeCommandLine::within(0, 1e6))
      ->option_text("METRES")
      ->needs(file)
      ->group(group);
  CLI::Option* elevation =
      command.add_option("--dem", dem, "Elevation file: the largest square of 2^n + 1 posts in its middle")
          ->check(TeCommandLine::notEmpty())
          ->option_text("FILE")
          ->excludes(file)
          ->group(group);
  reading.addTo(command, elevation, group);
}

TeResult<TeMeasuredTerrain> TeTerrainChoice::read() const {
  if (!map.empty())
    return TeMeasuredTerrain::readMap(map, cells, heightUnit);
  if (!dem.empty()) {
    const TeResult<TeElevationOptions> options = reading.options();
    if (!options)
      return options.error();
    return TeMeasuredTerrain::readDem(dem, *options);
  }
  return TeError{"--map or --dem is required"};
}

TeResult<TeMeasuredTerrain> TeTerrainChoice::readOrMountains(int samples) const {
  if (!map.empty() || !dem.empty())
    return read();
  return TeMeasuredTerrain::create("mountains", teMountains(samples), TeSmoothLand::kSpacing, 1);
}
