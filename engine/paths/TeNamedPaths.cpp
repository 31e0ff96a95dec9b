#include "engine/paths/TeNamedPaths.h"

#include "generators/base/TeMath.h"
#include "generators/base/TeText.h"

#include <algorithm>

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kCirclePoints = 96;
constexpr double kZigzagSide = 200;  ///< metres of a straight piece
constexpr double kZigzagRadius = 60; ///< of its corners
constexpr int kCornerPoints = 18;

using Points = std::vector<TePathPoint>;

class Drawer {
public:
  Drawer(const glm::dvec3& start, bool aboveGround) : m_place(start), m_aboveGround(aboveGround) {
    add(false);
  }

  void straight(double length) {
    m_place += length * glm::dvec3(teCos(m_heading), teSin(m_heading), 0);
    add(false);
  }
  /// Positive = to the left; radians. Chords of a circle.
  void turn(double radius, double angle, int points) {
    const double step = angle / points;
    const double chord = 2 * radius * std::abs(teSin(step / 2));
    for (int i = 0; i < points; ++i) {
      m_heading += i == 0 ? step / 2 : step;
      straight(chord);
    }
    m_heading += step / 2;
  }
  void jumpTo(const glm::dvec3& place) {
    m_place = place;
    add(true);
  }
  glm::dvec3 place() const { return m_place; }
  Points take() { return std::move(m_points); }

private:
  void add(bool jump) {
    TePathPoint point;
    point.place = m_place;
    point.aboveGround = m_aboveGround;
    point.jump = jump;
    m_points.push_back(point);
  }

  glm::dvec3 m_place;
  bool m_aboveGround;
  double m_heading = kPi / 2; ///< from east, counter-clockwise
  Points m_points;
};

Points line(Drawer drawer) {
  drawer.straight(1000);
  Points points = drawer.take();
  points.back().place.x = points.front().place.x;
  return points;
}

Points circle(Drawer drawer) {
  drawer.turn(kTeCircleRadius, 2 * kPi, kCirclePoints);
  Points points = drawer.take();
  points.back().place = points.front().place;
  return points;
}

Points zigzag(Drawer drawer) {
  const double x = drawer.place().x;
  drawer.turn(kZigzagRadius, -kPi / 4, kCornerPoints / 2);
  drawer.straight(kZigzagSide);
  drawer.turn(kZigzagRadius, kPi / 2, kCornerPoints);
  drawer.straight(kZigzagSide);
  drawer.turn(kZigzagRadius, -kPi / 4, kCornerPoints / 2);
  Points points = drawer.take();
  points.back().place.x = x;
  return points;
}

Points teleport(Drawer drawer) {
  const glm::dvec3 start = drawer.place();
  const glm::dvec3 jumps[] = {{1e6, 0, 0},   {1e9, 0, 0},  {1e11, 0, 0}, {-1e6, 0, 0},
                              {-1e11, 0, 0}, {0, -1e9, 0}, {0, 0, 0}};
  drawer.straight(kTeTeleportLeg);
  for (const glm::dvec3& jump : jumps) {
    drawer.jumpTo(start + jump);
    drawer.straight(kTeTeleportLeg);
  }
  drawer.jumpTo(start);
  return drawer.take();
}

} // namespace

const std::vector<std::string>& tePathNames() {
  static const std::vector<std::string> names = {"line", "circle", "zigzag", "teleport"};
  return names;
}

TeResult<TePath> teNamedPath(const std::string& name, const glm::dvec3& start, bool aboveGround) {
  const Drawer drawer(start, aboveGround);
  if (name == "line")
    return TePath::create(line(drawer), true);
  if (name == "circle")
    return TePath::create(circle(drawer), true);
  if (name == "zigzag")
    return TePath::create(zigzag(drawer), true);
  if (name == "teleport")
    return TePath::create(teleport(drawer), true);
  return TeError{"path " + teQuoted(name) + ": unknown" + teKnownNames(name, tePathNames())};
}
