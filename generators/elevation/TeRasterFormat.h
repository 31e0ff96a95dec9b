#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>
#include <string>

/// What tells one state of a file from another.
struct TeFileStamp {
  std::uint64_t bytes = 0;
  std::int64_t seconds = 0; ///< of the last change
  std::int64_t nanoseconds = 0;

  friend bool operator==(const TeFileStamp& a, const TeFileStamp& b) {
    return a.bytes == b.bytes && a.seconds == b.seconds && a.nanoseconds == b.nanoseconds;
  }
};

/// Size and age of a plain file. Error: missing, not readable, or no plain file (a folder, a pipe, a device).
TeResult<TeFileStamp> teFileStamp(const std::string& path);

/// Which of GDAL's drivers is to read a plain file, told by its first bytes (SRTM tiles, which have no
/// header, by ending and size): GTiff, PNG, BT, netCDF, SRTMHGT, AAIGrid or USGSDEM. So a file cannot choose
/// any other driver, and names like /vsicurl/… or a database's are no files. Error: unreadable, or none of
/// these.
TeResult<std::string> teRasterFormat(const std::string& path);
