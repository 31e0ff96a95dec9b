#include "apps/terrane-static/TeStaticWorld.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/elevation/TeElevationScan.h"
#include "generators/elevation/TeElevationSource.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr int kGeneratedSamples = 65;
constexpr int kElevationSamples = 513; ///< at most, by default

/// The samples at which a block over the whole file has about the file's own posts.
int suitingSamples(const TeElevationFile& file, int patches) {
  const double step = std::min(file.postSpacing().x, file.postSpacing().y);
  const double cells = std::max(file.extent().width(), file.extent().height()) / step / patches;
  return 2 * int(std::clamp(std::ceil(cells), 16.0, (kElevationSamples - 1) / 2.0)) + 1;
}

TeStatus placeOutside(const std::string& what, TeElevationPlacement& placement) {
  double height = 0;
  if (what == "clamp") {
    placement.outside = TeElevationOutside::Clamp;
  } else if (CLI::detail::lexical_cast(what, height)) {
    if (!(std::abs(height) <= 1e6))
      return TeError{"--outside: a height must lie within ±1000000 m, not '" + what + "'"};
    placement.outside = TeElevationOutside::Constant;
    placement.outsideHeight = float(height);
  } else if (what != "hole") {
    const TeResult<TeHeightSourcePtr> source = TeGeneratorRegistry::instance().source(what);
    if (!source)
      return TeError{"--outside: " + source.error().message};
    placement.outside = TeElevationOutside::Generator;
    placement.outsideSource = *source;
  }
  return {};
}

TeResult<TeElevationFilePtr> openFile(const TeStaticOptions& options) {
  TeElevationOptions reading;
  const TeResult<double> unit = teVerticalUnit(options.verticalUnit);
  if (!unit)
    return TeError{"--vertical-unit: " + unit.error().message};
  reading.verticalUnit = *unit;
  reading.posts = options.posts;
  reading.fillDistance = options.fillVoids ? 100 : 0;
  return TeElevationFile::open(options.dem, reading);
}

struct Terrain {
  TeHeightSourcePtr source;
  int samples;
  double spacing;
};

/// The whole file around the world's origin, or its native posts with the highest there.
TeResult<Terrain> elevationTerrain(const TeStaticOptions& options, glm::dvec2& centre) {
  const TeResult<TeElevationFilePtr> opened = openFile(options);
  if (!opened)
    return opened.error();
  const TeElevationFilePtr& file = *opened;
  TeElevationPlacement placement;
  if (const TeStatus ok = placeOutside(options.outside, placement); !ok)
    return ok.error();

  int samples = options.samples ? options.samples : suitingSamples(*file, options.block);
  double spacing = options.spacing;
  if (options.native) {
    const TeResult<double> native = file->nativeSpacing();
    if (!native)
      return native.error();
    const TeResult<TeElevationSummary> summary = TeElevationScan::summarise(file);
    if (!summary)
      return summary.error();
    spacing = *native;
    placement.native = true;
    placement.nativeColumn = summary->highestColumn;
    placement.nativeRow = summary->highestRow;
  } else if (spacing == 0) {
    const TeResult<double> covering = file->coveringSpacing(options.block, samples);
    if (!covering)
      return covering.error();
    spacing = *covering;
    // The middle of an even block is a corner of patches: the file's centre is moved there.
    const double side = spacing * ((samples - 1) / 2);
    const double shift = options.block % 2 == 0 ? side / 2 : 0;
    placement.origin = {-shift, -shift};
    centre += shift;
  }
  const TeResult<std::shared_ptr<const TeElevationSource>> source =
      TeElevationSource::create(file, placement);
  if (!source)
    return source.error();
  return Terrain{*source, samples, spacing};
}

TeResult<Terrain> generatedTerrain(const TeStaticOptions& options) {
  const std::string& specification =
      options.generator.empty() ? TeGeneratorRegistry::kDefaultGenerator : options.generator;
  const TeResult<TeHeightSourcePtr> source = TeGeneratorRegistry::instance().source(specification);
  if (!source)
    return source.error();
  return Terrain{*source, options.samples ? options.samples : kGeneratedSamples,
                 options.spacing != 0 ? options.spacing : 1.0};
}

} // namespace

TeResult<TeStaticWorld> TeStaticWorld::create(const TeStaticOptions& options, std::uint64_t seed) {
  TeStaticWorld made;
  made.centre = options.center;
  TeResult<Terrain> terrain =
      options.dem.empty() ? generatedTerrain(options) : elevationTerrain(options, made.centre);
  if (!terrain)
    return terrain.error();
  made.description = !options.dem.empty()        ? options.dem
                     : options.generator.empty() ? TeGeneratorRegistry::kDefaultGenerator
                                                 : options.generator;
  for (const std::string& specification : options.filters) {
    const TeResult<std::unique_ptr<TeFilter>> filter = TeGeneratorRegistry::instance().filter(specification);
    if (!filter)
      return filter.error();
    TeResult<TeHeightSourcePtr> filtered = (*filter)->apply(terrain->source);
    if (!filtered)
      return filtered.error();
    terrain->source = std::move(*filtered);
    made.description += " | " + specification;
  }
  const TeResult<TeLattice> lattice = TeLattice::create(terrain->samples, terrain->spacing);
  if (!lattice)
    return lattice.error();
  made.world.lattice = *lattice;
  made.world.seed = seed;
  made.world.sources = std::make_shared<TeSingleSource>(terrain->source);
  return made;
}
