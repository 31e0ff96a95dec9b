#pragma once

#include "generators/elevation/TeElevationOptions.h"
#include "generators/elevation/TeRasterFile.h"

#include <memory>
#include <string>

/// Opens a plain file as what the options or its first bytes say it is, after checking what its reader would
/// not notice or would take too long over: that a netCDF file is not cut off and that a text grid can hold
/// its posts at all. Error: see TeElevationFile::open(); also if it lacks the bands that the options ask for.
TeResult<std::unique_ptr<TeRasterFile>> teOpenRaster(const std::string& path,
                                                     const TeElevationOptions& options);
