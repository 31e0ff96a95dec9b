#include "engine/paths/TePath.h"

#include "engine/paths/TePathReader.h"
#include "generators/base/TeText.h"

#include <glm/geometric.hpp>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace {

bool inRange(const glm::dvec3& place) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(place[axis]) <= TePath::kMaxCoordinate))
      return false;
  return true;
}

} // namespace

std::string TePath::fault(const TePathPoint& point, const TePathPoint* before) {
  if (!inRange(point.place))
    return "coordinates must lie within ±" + teNumberText(kMaxCoordinate) + " m";
  if (!(point.speed >= 0 && point.speed <= kMaxSpeed))
    return "the speed must lie within 0 and " + teNumberText(kMaxSpeed) + " m/s";
  if (!before)
    return point.jump ? "the first point cannot be a jump" : "";
  if (point.jump)
    return "";
  if (point.aboveGround != before->aboveGround)
    return "a leg cannot lead from an altitude to a height above ground, or back; a jump can";
  if (glm::distance(point.place, before->place) < kMinLeg)
    return "the point is where the one before is";
  return "";
}

TeResult<TePath> TePath::create(std::vector<TePathPoint> points, bool repeats) {
  if (points.size() < 2 || points.size() > kMaxPoints)
    return TeError{"path of " + std::to_string(points.size()) + " points: must have 2 to " +
                   std::to_string(kMaxPoints)};
  TePath path;
  path.m_lengths.assign(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TePathPoint* before = i > 0 ? &points[i - 1] : nullptr;
    if (const std::string reason = fault(points[i], before); !reason.empty())
      return TeError{"path, point " + std::to_string(i + 1) + ": " + reason};
    if (before && !points[i].jump)
      path.m_lengths[i] = glm::distance(points[i].place, before->place);
    path.m_length += path.m_lengths[i];
  }
  if (path.m_length == 0)
    return TeError{"path of jumps alone: must have a leg"};
  if (repeats && points.front().aboveGround != points.back().aboveGround)
    return TeError{"path that repeats: its first and last point must both have altitudes or both heights "
                   "above ground"};
  path.m_points = std::move(points);
  path.m_repeats = repeats;
  return path;
}

TeResult<TePath> TePath::parse(std::string_view text, const std::string& name) {
  return TePathReader(name).read(text);
}

TeResult<TePath> TePath::read(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(kMaxBytes + 1, '\0');
  errno = 0;
  if (!stream || !(stream.read(text.data(), std::streamsize(text.size())) || stream.eof()))
    return TeError{file + ": cannot be read: " + std::strerror(errno ? errno : EIO)};
  text.resize(std::size_t(stream.gcount()));
  if (text.size() > kMaxBytes)
    return TeError{file + ": larger than " + std::to_string(kMaxBytes) + " bytes, too large for a path"};
  return parse(text, file);
}

glm::dvec3 TePath::roundShift() const {
  return m_repeats ? m_points.back().place - m_points.front().place : glm::dvec3(0);
}
