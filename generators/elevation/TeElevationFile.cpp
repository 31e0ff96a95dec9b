#include "generators/elevation/TeElevationFile.h"

#include "generators/TeLattice.h"
#include "generators/base/TeFloatEnvironment.h"
#include "generators/base/TeHash.h"
#include "generators/base/TeLog.h"
#include "generators/elevation/TeGdal.h"
#include "generators/elevation/TePlainFile.h"
#include "generators/elevation/TeRasterOpen.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace {

constexpr double kRadiansPerDegree = 0x1.1df46a2529d39p-6;
constexpr double kFoot = 0.3048;
constexpr double kUsFoot = 1200.0 / 3937;
constexpr double kSnap = 1e-6; ///< of a step between posts

TePlanePoint coordinates(const std::array<double, 6>& t, double column, double row) {
  return {t[0] + column * t[1] + row * t[2], t[3] + column * t[4] + row * t[5]};
}

/// Whether coordinates without a unit are degrees: all of them possible, and posts close together.
bool looksLikeDegrees(const TeRasterInfo& info) {
  const std::array<double, 6>& t = info.transform;
  const TePlanePoint a = coordinates(t, 0, 0);
  const TePlanePoint b = coordinates(t, info.columns, info.rows);
  const auto inside = [](double value, double low, double high) { return value >= low && value <= high; };
  return t[2] == 0 && t[4] == 0 && std::fabs(t[1]) < 0.1 && std::fabs(t[5]) < 0.1 && inside(a.x, -181, 361) &&
         inside(b.x, -181, 361) && inside(a.y, -91, 91) && inside(b.y, -91, 91);
}

double snapped(double value) {
  const double whole = std::floor(value + 0.5);
  return std::fabs(value - whole) < kSnap ? whole : value;
}

} // namespace

TeResult<TeElevationFilePtr> TeElevationFile::open(const std::string& path,
                                                   const TeElevationOptions& options) {
  const TeFloatEnvironment environment; // the frame's bits too
  std::shared_ptr<TeElevationFile> file(new TeElevationFile);
  file->m_path = path;
  if (TeStatus ok = options.check(); !ok)
    return TeError{path + ": " + ok.error().message};
  for (auto stage : {&TeElevationFile::openRaster, &TeElevationFile::computeFingerprint})
    if (TeStatus ok = (file.get()->*stage)(options); !ok)
      return ok.error();
  return TeElevationFilePtr(std::move(file));
}

TeStatus TeElevationFile::openRaster(const TeElevationOptions& options) {
  TeResult<std::unique_ptr<TeRasterFile>> raster = teOpenRaster(m_path, options);
  if (!raster)
    return raster.error();
  const TeRasterInfo info = (*raster)->info();
  m_projection = (*raster)->projection();
  chooseVerticalUnit(options, info);
  m_tiles = std::make_unique<TeElevationTiles>(std::move(*raster), options, m_verticalUnit);
  if (TeStatus ok = chooseFrame(options, info); !ok)
    return ok;
  return measure();
}

void TeElevationFile::chooseVerticalUnit(const TeElevationOptions& options, const TeRasterInfo& info) {
  m_verticalUnit = options.verticalUnit;
  if (m_verticalUnit == 0 && !info.verticalUnit.empty()) {
    const TeResult<double> unit = teVerticalUnit(info.verticalUnit);
    if (unit)
      m_verticalUnit = *unit;
    else
      TeLog::warning(m_path + ": heights have the unit \"" + info.verticalUnit + "\"; taken as metres");
  }
  if (m_verticalUnit == 0)
    m_verticalUnit = 1;
}

TeStatus TeElevationFile::chooseFrame(const TeElevationOptions& options, TeRasterInfo info) {
  if (options.posts > 0 || !info.hasTransform) {
    const double step = options.posts > 0 ? options.posts : 1;
    info.transform = {0, step, 0, 0, 0, -step};
    info.horizontal = TeHorizontalKind::Linear;
    info.horizontalUnit = 1;
    info.pixelIsPoint = info.pixelIsPoint || !info.hasTransform;
    m_projection = nullptr;
  } else if (options.horizontalUnit == TeHorizontalUnit::Degrees ||
             (options.horizontalUnit == TeHorizontalUnit::Automatic &&
              info.horizontal == TeHorizontalKind::Unknown && looksLikeDegrees(info))) {
    if (info.horizontal != TeHorizontalKind::Geographic) {
      info.horizontal = TeHorizontalKind::Geographic;
      info.horizontalUnit = kRadiansPerDegree;
      if (const TeResult<const TeGdal*> gdal = TeGdal::module(); gdal)
        m_projection = (*gdal)->geographicDegrees();
      TeLog::info(m_path + ": coordinates without a coordinate system are taken as degrees");
    }
  } else if (options.horizontalUnit != TeHorizontalUnit::Automatic) {
    info.horizontal = TeHorizontalKind::Linear;
    info.horizontalUnit = options.horizontalUnit == TeHorizontalUnit::Feet     ? kFoot
                          : options.horizontalUnit == TeHorizontalUnit::UsFeet ? kUsFoot
                                                                               : 1;
  }
  m_transform = info.transform;
  m_margin = info.pixelIsPoint ? 0 : 0.5;
  m_determinant = m_transform[1] * m_transform[5] - m_transform[2] * m_transform[4];
  m_centre = coordinates(m_transform, 0.5 * info.columns, 0.5 * info.rows);
  const double unit = info.horizontalUnit;
  if (!std::isfinite(m_determinant) || m_determinant == 0 || !std::isfinite(m_centre.x) ||
      !std::isfinite(m_centre.y) || !(unit > 0) || !std::isfinite(unit))
    return TeError{m_path + ": its georeference is not a plane of finite coordinates"};

  if (info.horizontal != TeHorizontalKind::Geographic) {
    m_frame = TeLocalFrame::linear(unit);
    return {};
  }
  const TePlanePoint extent{std::fabs(m_transform[1]) * info.columns + std::fabs(m_transform[2]) * info.rows,
                            std::fabs(m_transform[4]) * info.columns + std::fabs(m_transform[5]) * info.rows};
  m_fullTurn = 2 * 0x1.921fb54442d18p+1 / unit;
  if (std::fabs(m_centre.y) > 0.25 * m_fullTurn || extent.x > 1.01 * m_fullTurn ||
      extent.y > 0.51 * m_fullTurn || !(info.semiMajor > 1000) || !(info.semiMajor < 1e9) ||
      !(info.inverseFlattening == 0 || info.inverseFlattening > 2))
    return TeError{m_path + ": its longitudes and latitudes do not lie on the Earth"};
  m_frame = TeLocalFrame::geographic(m_centre.y * unit, unit, info.semiMajor, info.inverseFlattening, extent);
  return {};
}

TeStatus TeElevationFile::measure() {
  const double width = columns();
  const double height = rows();
  const double west = -m_margin;
  const double east = width - 1 + m_margin;
  const double north = -m_margin;
  const double south = height - 1 + m_margin;
  constexpr int kSteps = 64;
  m_extent = {INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (int i = 0; i <= kSteps; ++i) {
    const double u = west + (east - west) * i / kSteps;
    const double v = north + (south - north) * i / kSteps;
    for (TePlanePoint posts : {TePlanePoint{u, north}, {u, south}, {west, v}, {east, v}}) {
      TePlanePoint local;
      if (!toLocal(posts, local))
        return TeError{m_path + ": its coordinates lie beyond the local plane"};
      m_extent.west = std::min(m_extent.west, local.x);
      m_extent.east = std::max(m_extent.east, local.x);
      m_extent.south = std::min(m_extent.south, local.y);
      m_extent.north = std::max(m_extent.north, local.y);
    }
  }
  const auto distance = [this](TePlanePoint a, TePlanePoint b) {
    TePlanePoint p;
    TePlanePoint q;
    if (!toLocal(a, p) || !toLocal(b, q))
      return 0.0;
    return std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
  };
  const double u = 0.5 * (width - 1);
  const double v = 0.5 * (height - 1);
  m_postSpacing = {distance({u - 0.5, v}, {u + 0.5, v}), distance({u, v - 0.5}, {u, v + 0.5})};
  for (double step : {m_postSpacing.x, m_postSpacing.y})
    if (!(step >= 1e-6 && step <= 1e7))
      return TeError{m_path + ": posts " + std::to_string(step) + " m apart"};
  return {};
}

TeStatus TeElevationFile::computeFingerprint(const TeElevationOptions& options) {
  const TeResult<TeFileStamp> stamp = teFileStamp(m_path);
  if (!stamp)
    return stamp.error();
  const TeResult<TePlainFile> file = TePlainFile::open(m_path);
  if (!file)
    return file.error();
  std::uint64_t hash = teHashCombine(options.hash(), stamp->bytes);
  hash = teHashCombine(hash, std::uint64_t(stamp->seconds));
  hash = teHashCombine(hash, std::uint64_t(stamp->nanoseconds));
  std::vector<char> bytes(std::size_t(std::min<std::uint64_t>(file->bytes(), 65536)));
  for (std::uint64_t offset : {std::uint64_t(0), file->bytes() - bytes.size()}) {
    if (TeStatus ok = file->read(offset, bytes.data(), bytes.size()); !ok)
      return ok;
    hash = teHashBytes(bytes.data(), bytes.size(), hash);
  }
  m_fingerprint = hash;
  return {};
}

TeResult<double> TeElevationFile::nativeSpacing() const {
  if (m_frame.isGeographic())
    return TeError{m_path + ": its posts lie in degrees, so that their distance differs from place to place; "
                            "native posts need a projected file"};
  const double x = m_postSpacing.x;
  const double y = m_postSpacing.y;
  if (m_transform[2] != 0 || m_transform[4] != 0 || std::fabs(x - y) > 1e-9 * x)
    return TeError{m_path + ": its posts lie " + std::to_string(x) + " m and " + std::to_string(y) +
                   " m apart or on turned axes; native posts need equal steps to the east and north"};
  return x;
}

TeResult<float> TeElevationFile::post(int column, int row) const {
  assert(column >= 0 && column < columns() && row >= 0 && row < rows());
  const int side = m_tiles->side();
  const TeResult<TeElevationTiles::TilePtr> tile = m_tiles->tile(column / side, row / side);
  if (!tile)
    return TeError{m_path + ": " + tile.error().message};
  const TeElevationTile& t = **tile;
  return t.heights[std::size_t(row - t.row) * t.columns + std::size_t(column - t.column)];
}

bool TeElevationFile::toPosts(TePlanePoint local, TePlanePoint& posts) const {
  TePlanePoint offset;
  if (!m_frame.toFile(local, offset))
    return false;
  const std::array<double, 6>& t = m_transform;
  const double column = (offset.x * t[5] - offset.y * t[2]) / m_determinant;
  const double row = (offset.y * t[1] - offset.x * t[4]) / m_determinant;
  posts = {snapped(0.5 * (columns() - 1) + column), snapped(0.5 * (rows() - 1) + row)};
  return true;
}

bool TeElevationFile::toLocal(TePlanePoint posts, TePlanePoint& local) const {
  const double column = posts.x - 0.5 * (columns() - 1);
  const double row = posts.y - 0.5 * (rows() - 1);
  const std::array<double, 6>& t = m_transform;
  return m_frame.toLocal({column * t[1] + row * t[2], column * t[4] + row * t[5]}, local);
}

bool TeElevationFile::contains(TePlanePoint posts) const {
  const double slack = m_margin + kSnap;
  return posts.x >= -slack && posts.x <= columns() - 1 + slack && posts.y >= -slack &&
         posts.y <= rows() - 1 + slack;
}

TeResult<TeGeographicPosition> TeElevationFile::toGeographic(TePlanePoint local) const {
  if (!m_projection)
    return TeError{m_path + ": has no known coordinate system"};
  TePlanePoint offset;
  TeGeographicPosition position;
  if (!m_frame.toFile(local, offset) ||
      !m_projection->toGeographic(m_centre.x + offset.x, m_centre.y + offset.y, position))
    return TeError{m_path + ": the position has no longitude and latitude"};
  position.longitude -= 360 * std::floor((position.longitude + 180) / 360);
  return position;
}

TeResult<TePlanePoint> TeElevationFile::fromGeographic(TeGeographicPosition position) const {
  if (!m_projection)
    return TeError{m_path + ": has no known coordinate system"};
  TePlanePoint local;
  double x = 0;
  double y = 0;
  if (!(std::fabs(position.latitude) <= 90) || !(std::fabs(position.longitude) <= 720) ||
      !m_projection->fromGeographic(position, x, y))
    return TeError{m_path + ": longitude " + std::to_string(position.longitude) + ", latitude " +
                   std::to_string(position.latitude) + " has no position in its coordinate system"};
  TePlanePoint offset{x - m_centre.x, y - m_centre.y};
  if (m_fullTurn > 0)
    offset.x -= m_fullTurn * std::floor(offset.x / m_fullTurn + 0.5);
  if (!m_frame.toLocal(offset, local))
    return TeError{m_path + ": longitude " + std::to_string(position.longitude) + ", latitude " +
                   std::to_string(position.latitude) + " lies beyond the local plane"};
  return local;
}

TeResult<double> TeElevationFile::coveringSpacing(int patches, int samples) const {
  if (patches < 1)
    return TeError{"block " + std::to_string(patches) + ": must be at least 1"};
  const TeResult<TeLattice> lattice = TeLattice::create(samples, 1);
  if (!lattice)
    return lattice.error();
  const double half =
      std::max(std::max(-m_extent.west, m_extent.east), std::max(-m_extent.south, m_extent.north));
  return half > 0 ? 2 * half / (double(patches) * lattice->cells()) : m_postSpacing.x;
}
