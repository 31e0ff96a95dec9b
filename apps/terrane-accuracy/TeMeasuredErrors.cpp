#include "apps/terrane-accuracy/TeMeasuredErrors.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// Calls with column, row and distance of every sample in view.
template <class Work> void forEachInView(const TeMeasuredTerrain& terrain, const TeLodView& view, Work work) {
  for (int row = 0; row <= terrain.cells(); row++)
    for (int column = 0; column <= terrain.cells(); column++) {
      const glm::dvec3 point(column * terrain.spacing, row * terrain.spacing,
                             double(terrain.heights.at(column, row)) * terrain.heightScale);
      if (view.meets(point, point))
        work(column, row, glm::distance(view.eye, point));
    }
}

} // namespace

TeMeasuredErrors::Frame TeMeasuredErrors::add(const TeMeasuredTerrain& terrain, const TeLodView& view,
                                              const TeDrawnSurface& surface) {
  Frame frame;
  forEachInView(terrain, view, [&](int column, int row, double distance) {
    frame.inView++;
    const double drawn = double(surface.height(column, row));
    if (std::isnan(drawn)) {
      m_uncovered++;
      return;
    }
    const double metres = std::abs(drawn - double(terrain.heights.at(column, row))) * terrain.heightScale;
    const double pixels = view.pixels(metres, distance);
    frame.worstPixels = std::max(frame.worstPixels, pixels);
    m_worstMetres = std::max(m_worstMetres, metres);
    m_squares += pixels * pixels;
    m_samples++;
    m_histogram[std::size_t(std::min(double(kBins), pixels * kBinsPerPixel))]++;
  });
  m_worstPixels = std::max(m_worstPixels, frame.worstPixels);
  return frame;
}

void TeMeasuredErrors::addJump(const TeMeasuredTerrain& terrain, const TeLodView& view,
                               const TeDrawnSurface& before, const TeDrawnSurface& after) {
  forEachInView(terrain, view, [&](int column, int row, double distance) {
    const double jump = std::abs(double(after.height(column, row)) - double(before.height(column, row)));
    if (jump > 0) // not where a surface ends
      m_popping = std::max(m_popping, view.pixels(jump * terrain.heightScale, distance));
  });
}

double TeMeasuredErrors::rmsPixels() const {
  return m_samples ? std::sqrt(m_squares / double(m_samples)) : 0;
}

double TeMeasuredErrors::p999Pixels() const {
  std::int64_t above = m_samples / 1000;
  for (int bin = kBins; bin >= 0; bin--) {
    if (m_histogram[std::size_t(bin)] > above)
      return std::min(m_worstPixels, double(bin + 1) / kBinsPerPixel);
    above -= m_histogram[std::size_t(bin)];
  }
  return 0;
}
