#include "nodes/lod/geomipmap/TeGeoMipSampler.h"

#include "nodes/lod/TeLatticeTriangle.h"
#include "patchdb/TeTargetClones.h"

#include <cmath>
#include <limits>

namespace {

constexpr int kLanes = TeGeoMipSampler::kLanes;

TE_TARGET_CLONES
void worstDeviations(const TeGeoMipSampler::Weighted* samples, std::size_t count, const float* block,
                     double* worst) {
  double largest[kLanes] = {};
  for (std::size_t i = 0; i < count; i++) {
    const TeGeoMipSampler::Weighted& sample = samples[i];
    const float* height = block + std::size_t(sample.sample) * kLanes;
    const float* a = block + std::size_t(sample.corners[0]) * kLanes;
    const float* b = block + std::size_t(sample.corners[1]) * kLanes;
    const float* c = block + std::size_t(sample.corners[2]) * kLanes;
    const double wa = double(sample.weights[0]), wb = double(sample.weights[1]),
                 wc = double(sample.weights[2]);
    for (int lane = 0; lane < kLanes; lane++) {
      const double drawn = wa * double(a[lane]) + wb * double(b[lane]) + wc * double(c[lane]);
      const double deviation = std::fabs(double(height[lane]) - drawn);
      largest[lane] = deviation > largest[lane] ? deviation : largest[lane];
    }
  }
  for (int lane = 0; lane < kLanes; lane++)
    worst[lane] = largest[lane];
}

} // namespace

TeGeoMipSampler::Samples
TeGeoMipSampler::samples(const std::vector<TeGeoMipPatterns::Triangle>& triangles) const {
  Samples result;
  std::vector<bool> done(std::size_t(m_width) * std::size_t(m_width));
  const auto numberOf = [&](const TeGeoMipPatterns::Point& point) { return point.y * m_width + point.x; };
  for (const TeGeoMipPatterns::Triangle& triangle : triangles)
    for (const TeGeoMipPatterns::Point& corner : triangle)
      done[std::size_t(numberOf(corner))] = true;

  for (const TeGeoMipPatterns::Triangle& triangle : triangles) {
    const auto& [a, b, c] = triangle;
    const auto doubleArea = [](const TeGeoMipPatterns::Point& p, const TeGeoMipPatterns::Point& q,
                               const TeGeoMipPatterns::Point& r) {
      return (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
    };
    const float area = float(doubleArea(a, b, c));
    const TeLodVertex corners[3] = {{a.x, a.y, 0}, {b.x, b.y, 0}, {c.x, c.y, 0}};
    const TeLatticeTriangle lattice(corners[0], corners[1], corners[2]);
    for (int row = lattice.firstRow(); row <= lattice.lastRow(); row++) {
      const TeLatticeTriangle::Span span = lattice.span(row);
      for (int column = span.first; column <= span.last; column++) {
        const TeGeoMipPatterns::Point point{column, row};
        const int number = numberOf(point);
        if (done[std::size_t(number)]) // on an edge, both of whose triangles agree
          continue;
        done[std::size_t(number)] = true;
        result.push_back(
            {std::uint16_t(number),
             {std::uint16_t(numberOf(a)), std::uint16_t(numberOf(b)), std::uint16_t(numberOf(c))},
             {float(doubleArea(point, b, c)) / area, float(doubleArea(a, point, c)) / area,
              float(doubleArea(a, b, point)) / area}});
      }
    }
  }
  return result;
}

TeGeoMipSampler::Lanes TeGeoMipSampler::deviations(const Samples& samples, const Block& block) {
  double worst[kLanes];
  worstDeviations(samples.data(), samples.size(), block.data(), worst);
  Lanes result;
  for (std::size_t lane = 0; lane < kLanes; lane++) {
    const float rounded = float(worst[lane]);
    result[lane] = double(rounded) < worst[lane]
                       ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                       : rounded;
  }
  return result;
}
