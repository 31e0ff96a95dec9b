#include "generators/elevation/TeRasterFormat.h"

#include "generators/elevation/TePlainFile.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <vector>

namespace {

std::string lowerCase(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z')
      c = char(c - 'A' + 'a');
  return text;
}

bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool endsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool isTiff(std::string_view head) {
  using namespace std::string_view_literals;
  for (std::string_view magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
    if (startsWith(head, magic))
      return true;
  return false;
}

bool isAsciiGrid(std::string_view head) {
  const std::string start = lowerCase(std::string(head.substr(0, 100)));
  for (const char* key :
       {"ncols", "nrows", "xllcorner", "yllcorner", "xllcenter", "yllcenter", "dx", "dy", "cellsize"})
    if (startsWith(start, key))
      return true;
  return false;
}

// A USGS DEM's first record: three reference system numbers at 156 and a level and pattern code at 144.
bool isUsgsDem(std::string_view head) {
  if (head.size() < 200)
    return false;
  const std::string_view system = head.substr(156, 6);
  const std::string_view pattern = head.substr(150, 6);
  return (system == "     0" || system == "     1" || system == "     2" || system == "     3" ||
          system == " -9999") &&
         (pattern == "     1" || pattern == "     4");
}

} // namespace

TeResult<TeFileStamp> teFileStamp(const std::string& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) != 0)
    return TeError{path + ": " + std::strerror(errno)};
  if (!S_ISREG(status.st_mode))
    return TeError{path + ": not a plain file"};
  return TeFileStamp{std::uint64_t(status.st_size), status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

TeResult<std::string> teRasterFormat(const std::string& path) {
  using namespace std::string_view_literals;
  TeResult<TePlainFile> file = TePlainFile::open(path);
  if (!file)
    return file.error();
  std::vector<char> bytes(std::size_t(std::min<std::uint64_t>(file->bytes(), 1024)));
  if (TeStatus ok = file->read(0, bytes.data(), bytes.size()); !ok)
    return ok.error();
  const std::string_view head(bytes.data(), bytes.size());

  if (isTiff(head))
    return std::string("GTiff");
  if (startsWith(head, "\x89PNG\r\n\x1a\n"sv))
    return std::string("PNG");
  if (startsWith(head, "binterr1."sv))
    return std::string("BT");
  if (startsWith(head, "CDF\1"sv) || startsWith(head, "CDF\2"sv) || startsWith(head, "CDF\5"sv) ||
      startsWith(head, "\x89HDF\r\n\x1a\n"sv))
    return std::string("netCDF");
  if (endsWith(lowerCase(path), ".hgt"))
    return std::string("SRTMHGT");
  if (isAsciiGrid(head))
    return std::string("AAIGrid");
  if (isUsgsDem(head))
    return std::string("USGSDEM");
  return TeError{path + (head.empty()
                             ? ": empty file"
                             : ": none of GeoTIFF, PNG, BT, netCDF, SRTM HGT, Arc ASCII grid and USGS "
                               "DEM (headerless data needs encoding=raw and its size)")};
}
