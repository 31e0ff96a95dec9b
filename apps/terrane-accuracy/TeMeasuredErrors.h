#pragma once

#include "apps/terrane-accuracy/TeDrawnSurface.h"

#include <cstdint>
#include <vector>

/// Errors of drawn surfaces against all samples in view, over many frames. The error of a sample is the
/// vertical deviation there, in pixels at the sample's distance from the eye (TeLodView::pixels), whether or
/// not something hides it.
class TeMeasuredErrors {
public:
  struct Frame {
    double worstPixels = 0;
    std::int64_t inView = 0;
  };

  /// Adds a frame.
  Frame add(const TeMeasuredTerrain& terrain, const TeLodView& view, const TeDrawnSurface& surface);
  /// Adds what samples in view jump by from one frame to the next.
  void addJump(const TeMeasuredTerrain& terrain, const TeLodView& view, const TeDrawnSurface& before,
               const TeDrawnSurface& after);

  double worstPixels() const { return m_worstPixels; }
  double worstMetres() const { return m_worstMetres; }
  double rmsPixels() const;
  /// That 99.9 % of the samples of all frames do not exceed; to 1/256 pixel, up to 256.
  double p999Pixels() const;
  double popping() const { return m_popping; } ///< largest jump, pixels
  std::int64_t uncovered() const { return m_uncovered; }
  std::int64_t samples() const { return m_samples; }

private:
  static constexpr int kBinsPerPixel = 256;
  static constexpr int kBins = 256 * kBinsPerPixel;

  double m_worstPixels = 0;
  double m_worstMetres = 0;
  double m_popping = 0;
  double m_squares = 0;
  std::int64_t m_uncovered = 0;
  std::int64_t m_samples = 0;
  std::vector<std::int64_t> m_histogram = std::vector<std::int64_t>(kBins + 1);
};
