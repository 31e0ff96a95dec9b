#include "apps/common/TeAppWorld.h"

#include "generators/TeGeneratorRegistry.h"
#include "nodes/terrain/TeElevationTerrain.h"

#include <cmath>

namespace {

constexpr int kGeneratedSamples = 65;

struct Terrain {
  TeHeightSourcePtr source;
  int samples;
  double spacing;
};

TeStatus placeOutside(const std::string& what, TeElevationTerrainOptions& elevation) {
  double height = 0;
  if (what == "clamp") {
    elevation.outside = TeElevationOutside::Clamp;
  } else if (CLI::detail::lexical_cast(what, height)) {
    if (!(std::abs(height) <= 1e6))
      return TeError{"--outside: a height must lie within ±1000000 m, not '" + what + "'"};
    elevation.outside = TeElevationOutside::Constant;
    elevation.outsideHeight = float(height);
  } else if (what != "hole") {
    const TeResult<TeHeightSourcePtr> source = TeGeneratorRegistry::instance().source(what);
    if (!source)
      return TeError{"--outside: " + source.error().message};
    elevation.outside = TeElevationOutside::Generator;
    elevation.outsideSource = *source;
  }
  return {};
}

/// The whole file around the world's origin, or its native posts with the highest there.
TeResult<Terrain> elevationTerrain(const TeTerrainOptions& options, int patches, glm::dvec2& centre) {
  TeElevationTerrainOptions elevation;
  elevation.file = options.dem;
  const TeResult<TeElevationOptions> reading = options.reading.options();
  if (!reading)
    return reading.error();
  elevation.reading = *reading;
  if (const TeStatus ok = placeOutside(options.outside, elevation); !ok)
    return ok.error();
  elevation.native = options.native;
  elevation.patches = patches;
  elevation.samples = options.samples;
  elevation.spacing = options.spacing;
  const TeResult<TeElevationTerrain> opened = TeElevationTerrain::open(elevation);
  if (!opened)
    return opened.error();
  centre = opened->centre;
  return Terrain{opened->source, opened->samples, opened->spacing};
}

TeResult<Terrain> generatedTerrain(const TeTerrainOptions& options) {
  const TeResult<TeHeightSourcePtr> source = TeGeneratorRegistry::instance().source(options.generator);
  if (!source)
    return source.error();
  return Terrain{*source, options.samples != 0 ? options.samples : kGeneratedSamples,
                 options.spacing != 0 ? options.spacing : 1.0};
}

} // namespace

TeResult<TeAppWorld> TeAppWorld::create(const TeTerrainOptions& options, int patches, std::uint64_t seed) {
  TeAppWorld made;
  const TeResult<Terrain> terrain =
      options.dem.empty() ? generatedTerrain(options) : elevationTerrain(options, patches, made.centre);
  if (!terrain)
    return terrain.error();
  made.description = options.dem.empty() ? options.generator : options.dem;
  for (const std::string& specification : options.filters)
    made.description += " | " + specification;
  TeResult<TeHeightSourcePtr> source =
      TeGeneratorRegistry::instance().filtered(terrain->source, options.filters);
  if (!source)
    return source.error();
  const TeResult<TeLattice> lattice = TeLattice::create(terrain->samples, terrain->spacing);
  if (!lattice)
    return lattice.error();
  if (const TeStatus ok = (*source)->accepts(terrain->samples, terrain->samples); !ok)
    return ok.error();
  made.world.lattice = *lattice;
  made.world.seed = seed;
  made.source = std::move(*source);
  made.world.sources = std::make_shared<TeSingleSource>(made.source);
  made.world.blending = options.blending;
  return made;
}
