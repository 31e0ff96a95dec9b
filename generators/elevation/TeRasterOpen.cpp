#include "generators/elevation/TeRasterOpen.h"

#include "generators/elevation/TeClassicNetCdf.h"
#include "generators/elevation/TeGdal.h"
#include "generators/elevation/TeRasterFormat.h"
#include "generators/elevation/TeRawRasterFile.h"

namespace {

// A post in a text grid takes a digit and a separator at least; GDAL would look for them all over again for
// every row that is not there.
TeStatus checkTextSize(const std::string& path, const TeRasterInfo& info) {
  const TeResult<TeFileStamp> stamp = teFileStamp(path);
  if (!stamp)
    return stamp.error();
  const std::uint64_t needed = 2 * std::uint64_t(info.columns) * std::uint64_t(info.rows) - 1;
  if (stamp->bytes >= needed)
    return {};
  return TeError{path + ": " + std::to_string(stamp->bytes) + " bytes, but " + std::to_string(info.columns) +
                 "x" + std::to_string(info.rows) + " posts take at least " + std::to_string(needed)};
}

TeResult<std::unique_ptr<TeRasterFile>> openWithGdal(const std::string& path,
                                                     const TeElevationOptions& options) {
  const TeResult<std::string> format = teRasterFormat(path);
  if (!format)
    return format.error();
  if (*format == "netCDF")
    if (TeStatus ok = teCheckClassicNetCdf(path); !ok)
      return ok.error();
  const TeResult<const TeGdal*> gdal = TeGdal::module();
  if (!gdal)
    return TeError{path + ": " + gdal.error().message};
  TeResult<std::unique_ptr<TeRasterFile>> raster =
      (*gdal)->open(path, *format, options.variable, options.band);
  if (raster && *format == "AAIGrid")
    if (TeStatus ok = checkTextSize(path, (*raster)->info()); !ok)
      return ok.error();
  return raster;
}

} // namespace

TeResult<std::unique_ptr<TeRasterFile>> teOpenRaster(const std::string& path,
                                                     const TeElevationOptions& options) {
  TeResult<std::unique_ptr<TeRasterFile>> raster = options.encoding == TeElevationEncoding::Raw
                                                       ? TeRawRasterFile::open(path, options)
                                                       : openWithGdal(path, options);
  if (!raster)
    return raster;
  const int bands = (*raster)->info().bands;
  const int needed = options.band + (options.encoding == TeElevationEncoding::Terrarium ? 2 : 0);
  if (bands < needed)
    return TeError{path + ": has " + std::to_string(bands) + " bands, but band " + std::to_string(needed) +
                   " is needed"};
  return raster;
}
