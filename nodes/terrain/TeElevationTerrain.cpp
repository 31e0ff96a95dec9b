#include "nodes/terrain/TeElevationTerrain.h"

#include "generators/elevation/TeElevationScan.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kFewestCells = 16; ///< of a patch

/// The samples at which a block over the whole file has about the file's own posts.
int samplesLikePosts(const TeElevationFile& file, int patches) {
  const double step = std::min(file.postSpacing().x, file.postSpacing().y);
  const double cells = std::max(file.extent().width(), file.extent().height()) / step / std::max(patches, 1);
  const double most = (TeElevationTerrain::kMostSamples - 1) / 2.0;
  return 2 * int(std::clamp(std::ceil(cells), kFewestCells, most)) + 1;
}

} // namespace

TeResult<TeElevationTerrain> TeElevationTerrain::open(const TeElevationTerrainOptions& options) {
  const TeResult<TeElevationFilePtr> opened = TeElevationFile::open(options.file, options.reading);
  if (!opened)
    return opened.error();
  const TeElevationFilePtr& file = *opened;
  TeElevationTerrain terrain;
  TeElevationPlacement placement;
  placement.outside = options.outside;
  placement.outsideHeight = options.outsideHeight;
  placement.outsideSource = options.outsideSource;
  terrain.samples = options.samples != 0 ? options.samples : samplesLikePosts(*file, options.patches);
  terrain.spacing = options.spacing;
  if (options.native) {
    const TeResult<double> spacing = file->nativeSpacing();
    if (!spacing)
      return spacing.error();
    const TeResult<TeElevationSummary> summary = TeElevationScan::summarise(file);
    if (!summary)
      return summary.error();
    terrain.spacing = *spacing;
    placement.native = true;
    placement.nativeColumn = summary->highestColumn;
    placement.nativeRow = summary->highestRow;
  } else if (options.spacing == 0) {
    const TeResult<double> spacing = file->coveringSpacing(options.patches, terrain.samples);
    if (!spacing)
      return spacing.error();
    terrain.spacing = *spacing;
    // The middle of an even block is a corner of patches: the file's centre is moved there.
    const double side = terrain.spacing * ((terrain.samples - 1) / 2);
    const double shift = options.patches % 2 == 0 ? side / 2 : 0;
    placement.origin = {-shift, -shift};
    terrain.centre = {shift, shift};
  }
  const TeResult<std::shared_ptr<const TeElevationSource>> source =
      TeElevationSource::create(file, placement);
  if (!source)
    return source.error();
  terrain.source = *source;
  return terrain;
}
