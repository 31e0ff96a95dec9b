#include "apps/terrane-view/TeDemMap.h"

#include "generators/elevation/TeElevationReader.h"

#include <algorithm>

namespace {

bool isPowerOfTwo(int number) { return number > 0 && (number & (number - 1)) == 0; }

/// A square file of 2^n + 1 posts a side, the same distance apart.
bool isSuchASquare(const TeElevationFile& file) {
  const TeResult<double> spacing = file.nativeSpacing();
  return spacing && file.columns() == file.rows() && isPowerOfTwo(file.columns() - 1) &&
         file.columns() - 1 >= TeDemMap::kMinCells && file.columns() - 1 <= TeDemMap::kMaxCells;
}

int cellsLike(double cells) {
  int power = TeDemMap::kMinCells;
  while (power < cells && power < TeDemMap::kMaxCells)
    power *= 2;
  return power;
}

/// One row of a map from the posts themselves.
TeStatus readPosts(TeElevationReader& reader, int row, TeHeightMap& map) {
  const TeElevationFile& file = reader.file();
  const int last = file.columns() - 1;
  for (int column = 0; column <= last; ++column) {
    const int x = file.columnsRunEast() ? column : last - column;
    const int y = file.rowsRunNorth() ? row : last - row;
    if (const TeStatus ok = reader.post(x, y, map.at(column, row)); !ok)
      return ok;
  }
  return {};
}

/// One row of a map around the file's centre from the heights between posts.
TeStatus readBetween(TeElevationReader& reader, double spacing, int row, TeHeightMap& map) {
  const TeLocalExtent& extent = reader.file().extent();
  const TePlanePoint centre{0.5 * (extent.west + extent.east), 0.5 * (extent.south + extent.north)};
  const double middle = 0.5 * (map.width() - 1);
  for (int column = 0; column < map.width(); ++column) {
    const TePlanePoint local{centre.x + (column - middle) * spacing, centre.y + (row - middle) * spacing};
    TePlanePoint posts;
    if (!reader.file().toPosts(local, posts)) {
      map.at(column, row) = TeHeightMap::missing();
      continue;
    }
    if (const TeStatus ok = reader.height(posts, map.at(column, row)); !ok)
      return ok;
  }
  return {};
}

} // namespace

TeResult<TeDemMap> TeDemMap::read(const std::string& path, const TeElevationOptions& options, int cells,
                                  const std::function<void(double)>& progress) {
  const TeResult<TeElevationFilePtr> opened = TeElevationFile::open(path, options);
  if (!opened)
    return opened.error();
  const TeElevationFile& file = **opened;
  TeDemMap dem;
  dem.resampled = !isSuchASquare(file) || (cells != 0 && cells != file.columns() - 1);
  if (dem.resampled) {
    const double side = std::min(file.extent().width(), file.extent().height());
    const double step = std::min(file.postSpacing().x, file.postSpacing().y);
    dem.cropped = std::max(file.extent().width(), file.extent().height()) > side + step;
    cells = cells != 0 ? cells : cellsLike(side / step);
    dem.spacing = side / cells;
  } else {
    cells = file.columns() - 1;
    dem.spacing = *file.nativeSpacing();
  }
  TeResult<TeHeightMap> map = TeHeightMap::create(cells + 1, cells + 1);
  if (!map)
    return TeError{path + ": " + map.error().message};
  TeElevationReader reader(*opened);
  for (int row = 0; row <= cells; ++row) {
    const TeStatus ok =
        dem.resampled ? readBetween(reader, dem.spacing, row, *map) : readPosts(reader, row, *map);
    if (!ok)
      return ok.error();
    progress(double(row + 1) / (cells + 1));
  }
  if (const std::int64_t missing = map->statistics().missing; missing > 0)
    return TeError{path + ": " + std::to_string(missing) + " of " +
                   std::to_string(std::int64_t(cells + 1) * (cells + 1)) +
                   " heights are missing; --fill voids fills small gaps from their surroundings"};
  dem.heights = std::make_shared<const TeHeightMap>(std::move(*map));
  return dem;
}
