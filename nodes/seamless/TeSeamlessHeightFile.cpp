#include "nodes/seamless/TeSeamlessHeightFile.h"

#include "generators/elevation/TeElevationFile.h"
#include "generators/elevation/TeElevationReader.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace {

bool isPowerOfTwo(int number) { return number > 0 && (number & (number - 1)) == 0; }

bool endsWithRaw(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return ending == ".raw";
}

TeResult<int> rawSide(const std::string& path) {
  const TeResult<TeFileStamp> stamp = teFileStamp(path);
  if (!stamp)
    return stamp.error();
  const int side = int(std::lround(std::sqrt(double(stamp->bytes / 2))));
  if (!isPowerOfTwo(side - 1) || stamp->bytes != 2 * std::uint64_t(side) * std::uint64_t(side))
    return TeError{path + ": " + std::to_string(stamp->bytes) +
                   " bytes are no square of 2^n+1 samples of 16 bits"};
  return side;
}

TeResult<TeElevationFilePtr> openFile(const std::string& path, double verticalUnit) {
  TeElevationOptions options;
  options.verticalUnit = verticalUnit;
  if (endsWithRaw(path)) {
    const TeResult<int> side = rawSide(path);
    if (!side)
      return side.error();
    options.encoding = TeElevationEncoding::Raw;
    options.rawColumns = *side;
    options.rawRows = *side;
    options.rawSigned = false;
  }
  return TeElevationFile::open(path, options);
}

/// Whether columns run east, and rows north.
TeStatus findDirections(const TeElevationFile& file, bool& east, bool& north) {
  TePlanePoint first, right, below;
  if (!file.toLocal({0, 0}, first) || !file.toLocal({1, 0}, right) || !file.toLocal({0, 1}, below))
    return TeError{file.path() + ": its first samples have no place"};
  if (std::abs(right.x - first.x) < std::abs(right.y - first.y))
    return TeError{file.path() + ": its rows do not run east and west"};
  east = right.x > first.x;
  north = below.y > first.y;
  return {};
}

} // namespace

TeResult<TeSeamlessHeightFile> TeSeamlessHeightFile::read(const std::string& path, double verticalUnit) {
  const TeResult<TeElevationFilePtr> file = openFile(path, verticalUnit);
  if (!file)
    return file.error();
  const int side = (*file)->columns();
  if (side != (*file)->rows() || !isPowerOfTwo(side - 1))
    return TeError{path + ": " + std::to_string(side) + "x" + std::to_string((*file)->rows()) +
                   " samples are no square of 2^n+1; terrane-bake mipmaps --resample makes one"};
  bool east = true;
  bool north = false;
  TeSeamlessHeightFile result;
  result.isRaw = endsWithRaw(path);
  if (!result.isRaw) {
    if (TeStatus status = findDirections(**file, east, north); !status)
      return status.error();
    if (const TeResult<double> spacing = (*file)->nativeSpacing())
      result.spacing = *spacing;
  }
  TeResult<TeHeightMap> map = TeHeightMap::create(side, side);
  if (!map)
    return TeError{path + ": " + map.error().message + "; larger terrain is drawn from clipmaps"};
  TeElevationReader reader(*file);
  std::int64_t missing = 0;
  for (int y = 0; y < side; y++) {
    const int row = north ? y : side - 1 - y;
    for (int x = 0; x < side; x++) {
      if (TeStatus status = reader.post(east ? x : side - 1 - x, row, map->at(x, y)); !status)
        return status.error();
      missing += TeHeightMap::isMissing(map->at(x, y));
    }
  }
  if (missing > 0)
    return TeError{path + ": " + std::to_string(missing) + " samples are missing; fill them first"};
  result.map = std::move(*map);
  return result;
}
