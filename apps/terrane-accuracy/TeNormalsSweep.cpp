#include "apps/terrane-accuracy/TeNormalsSweep.h"

#include "generators/base/TeAllowance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kDegreesARadian = 57.29577951308232;

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return kDegreesARadian * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// True normals of all samples within a margin, by rows.
class Exact {
public:
  Exact(const TeNormalsTerrain& terrain, int first, int end) : m_first(first), m_side(end - first) {
    m_normals.reserve(std::size_t(m_side) * std::size_t(m_side));
    for (int row = first; row < end; ++row)
      for (int column = first; column < end; ++column)
        m_normals.push_back(terrain.exact(column, row));
  }
  const glm::dvec3& at(int column, int row) const {
    return m_normals[std::size_t(row - m_first) * std::size_t(m_side) + std::size_t(column - m_first)];
  }

private:
  int m_first;
  int m_side;
  std::vector<glm::dvec3> m_normals;
};

/// Vertices every `step` samples: first, first + step … last.
struct Vertices {
  int first, last, step;
  int side() const { return (last - first) / step + 1; }
};

void measureAngles(const Vertices& vertices, const std::vector<glm::vec3>& normals, const Exact& exact,
                   TeNormalsFigures& figures) {
  const int side = vertices.side(), step = vertices.step;
  const auto normal = [&](int x, int y) {
    return glm::dvec3(normals[std::size_t(y) * std::size_t(side) + std::size_t(x)]);
  };
  double sumAtVertices = 0, sum = 0;
  std::int64_t samples = 0;
  for (int row = vertices.first; row <= vertices.last; ++row)
    for (int column = vertices.first; column <= vertices.last; ++column) {
      const int x = std::min((column - vertices.first) / step, std::max(0, side - 2));
      const int y = std::min((row - vertices.first) / step, std::max(0, side - 2));
      const double u = double(column - vertices.first - x * step) / step;
      const double v = double(row - vertices.first - y * step) / step;
      // Cells are split along the diagonal from south-west to north-east.
      const glm::dvec3 corner = u >= v ? normal(x + 1, y) : normal(x, y + 1);
      const glm::dvec3 drawn = (1 - std::max(u, v)) * normal(x, y) + std::fabs(u - v) * corner +
                               std::min(u, v) * normal(x + 1, y + 1);
      const double angle = angleBetween(drawn, exact.at(column, row));
      sum += angle;
      figures.worst = std::max(figures.worst, angle);
      ++samples;
      if ((column - vertices.first) % step == 0 && (row - vertices.first) % step == 0) {
        sumAtVertices += angle;
        figures.worstAtVertices = std::max(figures.worstAtVertices, angle);
      }
    }
  figures.mean = sum / double(samples);
  figures.meanAtVertices = sumAtVertices / (double(side) * side);
}

/// Seconds of one making of the normals: repeated until that can be measured.
double secondsOf(const TeNormalsTerrain& terrain, TeNormalWay way, const Vertices& vertices, int stepOfData,
                 std::vector<glm::vec3>& normals) {
  constexpr double kLeast = 2e-4;
  int count = 0;
  double passed = 0;
  const double start = teThreadCpuSeconds();
  do {
    teNormalsBy(way, *terrain.heights, vertices.first, vertices.last + 1, vertices.step, stepOfData,
                terrain.spacing, normals.data());
    ++count;
    passed = teThreadCpuSeconds() - start;
  } while (passed < kLeast);
  return passed / count;
}

} // namespace

std::vector<TeNormalsFigures> teMeasureNormals(const TeNormalsTerrain& terrain, int levels, int runs) {
  const int cells = terrain.heights->width() - 1;
  // All levels look at the same samples, at least two of their cells a side.
  while (levels > 1 && 4 * (1 << (levels - 1)) > cells)
    --levels;
  const int margin = 1 << (levels - 1);
  const Exact exact(terrain, margin, cells - margin + 1);
  const auto verticesOf = [&](int level) { return Vertices{margin, cells - margin, 1 << level}; };

  std::vector<TeNormalsFigures> all;
  std::vector<std::vector<double>> ns;
  for (int level = 0; level < levels; ++level)
    for (const bool fromFine : {true, false})
      for (const TeNormalWay way : kTeNormalWays) {
        if (level == 0 && !fromFine)
          continue;
        const Vertices vertices = verticesOf(level);
        TeNormalsFigures figures;
        figures.way = way;
        figures.level = level;
        figures.fromFine = fromFine;
        figures.vertices = std::int64_t(vertices.side()) * vertices.side();
        std::vector<glm::vec3> normals(std::size_t(figures.vertices));
        teNormalsBy(way, *terrain.heights, vertices.first, vertices.last + 1, vertices.step,
                    fromFine ? 1 : vertices.step, terrain.spacing, normals.data());
        measureAngles(vertices, normals, exact, figures);
        all.push_back(figures);
      }
  ns.resize(all.size());
  std::vector<glm::vec3> normals(std::size_t(all.front().vertices));
  (void)secondsOf(terrain, all.front().way, verticesOf(0), 1, normals); // fills the caches
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vertices vertices = verticesOf(all[i].level);
      const double seconds =
          secondsOf(terrain, all[i].way, vertices, all[i].fromFine ? 1 : vertices.step, normals);
      ns[i].push_back(1e9 * seconds / double(all[i].vertices));
    }
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].ns = TeSpread::of(ns[i]);
    std::vector<double> ratios;
    for (int run = 0; run < runs; ++run)
      ratios.push_back(ns[i][std::size_t(run)] / ns[0][std::size_t(run)]);
    all[i].ratio = TeSpread::of(ratios).median;
  }
  return all;
}
