#include "apps/terrane-accuracy/TeMeasuredTerrain.h"

#include "generators/base/TeText.h"
#include "generators/elevation/TeElevationFile.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace {

constexpr int kLeastSamples = 17;

/// The largest 2^n + 1 that is not more.
int fitting(std::int64_t samples) {
  int side = kLeastSamples;
  while (2 * (side - 1) + 1 <= std::min<std::int64_t>(samples, TeMeasuredTerrain::kMaxSamples))
    side = 2 * (side - 1) + 1;
  return side;
}

} // namespace

TeMapRect TeMeasuredTerrain::middle(int samples) const {
  const int side = std::min(samples, heights().width());
  const int first = (heights().width() - side) / 2;
  return {first, first, side, side};
}

TeFlyover TeMeasuredTerrain::flyover() const {
  TeFlyover flight;
  flight.cells = cells();
  flight.spacing = spacing();
  flight.heightScale = heightScale();
  flight.sample = [field = field](std::int32_t column, std::int32_t row) {
    return field->height(column, row);
  };
  return flight;
}

TeResult<TeMeasuredTerrain> TeMeasuredTerrain::create(const std::string& name, TeHeightMap heights,
                                                      double spacing, double heightScale) {
  TeLodField::Placement placement;
  placement.spacing = spacing;
  placement.heightScale = heightScale;
  TeResult<TeLodFieldPtr> field =
      TeLodField::create(std::make_shared<const TeHeightMap>(std::move(heights)), placement);
  if (!field)
    return TeError{name + ": " + field.error().message};
  return TeMeasuredTerrain{name, std::move(*field)};
}

TeResult<TeMeasuredTerrain> TeMeasuredTerrain::readMap(const std::string& file, double spacing,
                                                       double heightScale) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    return TeError{file + ": is no file"};
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (error)
    return TeError{file + ": " + error.message()};
  const int side = fitting(std::int64_t(std::sqrt(double(bytes) / 2)));
  if (bytes != 2 * std::uintmax_t(side) * std::uintmax_t(side))
    return TeError{file + teFormat(": %llu bytes are no square of 2^n + 1 samples of 16 bits, n from 4 to 13",
                                   static_cast<unsigned long long>(bytes))};
  TeResult<TeHeightMap> map = TeHeightMap::create(side, side);
  if (!map)
    return map.error();

  std::ifstream stream(file, std::ios::binary);
  std::vector<unsigned char> row(2 * std::size_t(side));
  for (int y = 0; y < side; y++) {
    if (!stream.read(reinterpret_cast<char*>(row.data()), std::streamsize(row.size())))
      return TeError{file + ": cannot be read: " + std::strerror(errno)};
    for (int x = 0; x < side; x++)
      map->at(x, y) = float(row[2 * std::size_t(x)] + 256 * row[2 * std::size_t(x) + 1]);
  }
  return create(file, std::move(*map), spacing, heightScale);
}

TeResult<TeMeasuredTerrain> TeMeasuredTerrain::readDem(const std::string& file,
                                                       const TeElevationOptions& options) {
  const TeResult<TeElevationFilePtr> opened = TeElevationFile::open(file, options);
  if (!opened)
    return opened.error();
  const TeElevationFile& dem = **opened;
  const TeResult<double> spacing = dem.nativeSpacing();
  if (!spacing)
    return spacing.error();
  const int least = std::min(dem.columns(), dem.rows());
  if (least < kLeastSamples)
    return TeError{file + teFormat(": %d × %d posts are too few, at least %d a side are needed",
                                   dem.columns(), dem.rows(), kLeastSamples)};
  const int side = fitting(least);
  TeResult<TeHeightMap> map = TeHeightMap::create(side, side);
  if (!map)
    return map.error();
  const int firstColumn = (dem.columns() - side) / 2;
  const int firstRow = (dem.rows() - side) / 2;
  for (int row = 0; row < side; row++)
    for (int column = 0; column < side; column++) {
      const TeResult<float> height = dem.post(firstColumn + column, firstRow + row);
      if (!height)
        return height.error();
      if (TeHeightMap::isMissing(*height))
        return TeError{file + teFormat(": the height of post (%d, %d) is missing", firstColumn + column,
                                       firstRow + row)};
      map->at(dem.columnsRunEast() ? column : side - 1 - column, dem.rowsRunNorth() ? row : side - 1 - row) =
          *height;
    }
  return create(file, std::move(*map), *spacing, 1);
}
