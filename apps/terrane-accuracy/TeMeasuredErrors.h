#pragma once

#include "apps/terrane-accuracy/TeDrawnSurface.h"
#include "nodes/lod/TeLodField.h"
#include "nodes/lod/TeScreenError.h"

#include <cstdint>

/// Errors of drawn surfaces against all samples in view, over many frames (TeScreenError).
class TeMeasuredErrors {
public:
  /// Adds a frame.
  void add(const TeScreenError::Report& report);
  /// Adds what samples in view jump by from one frame to the next.
  void addJump(const TeLodField& field, const TeLodView& view, const TeDrawnSurface& before,
               const TeDrawnSurface& after);

  double worstPixels() const { return m_worstPixels; }
  double worstMetres() const { return m_worstMetres; }
  double rmsPixels() const; ///< over the samples of all frames
  /// Largest of the frames' errors that 99.9 % of their samples do not exceed.
  double p999Pixels() const { return m_p999Pixels; }
  double popping() const { return m_popping; } ///< largest jump, pixels
  std::int64_t uncovered() const { return m_uncovered; }
  std::int64_t samples() const { return m_samples; }

private:
  double m_worstPixels = 0;
  double m_p999Pixels = 0;
  double m_worstMetres = 0;
  double m_popping = 0;
  double m_squares = 0;
  std::int64_t m_uncovered = 0;
  std::int64_t m_samples = 0;
};
