#include "nodes/terrain/TeElevationTerrain.h"

#include "generators/elevation/TeElevationScan.h"
#include "generators/elevation/TeElevationSource.h"

TeResult<TeElevationTerrain> TeElevationTerrain::open(const TeElevationTerrainOptions& options) {
  const TeResult<TeElevationFilePtr> opened = TeElevationFile::open(options.file, options.reading);
  if (!opened)
    return opened.error();
  const TeElevationFilePtr& file = *opened;
  TeElevationTerrain terrain;
  TeElevationPlacement placement;
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
    const TeResult<double> spacing = file->coveringSpacing(options.patches, options.samples);
    if (!spacing)
      return spacing.error();
    terrain.spacing = *spacing;
    // The middle of an even block is a corner of patches: the file's centre is moved there.
    const double side = terrain.spacing * ((options.samples - 1) / 2);
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
