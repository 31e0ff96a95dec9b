#pragma once

#include "generators/TeHeightSource.h"
#include "generators/filters/TeMatrix.h"

/// What TeMatrixFilter makes: the maps of another source, matrix-filtered.
class TeMatrixSource final : public TeHeightSource {
public:
  TeMatrixSource(TeHeightSourcePtr input, TeMatrix matrix);

  /// Whether an input's heights beyond a map's border can be had, and are those of the neighbouring map.
  static bool reachesBeyondBorders(const TeHeightSource& input) {
    return input.fits() && input.pointEvaluable();
  }

  std::string name() const override { return m_input->name() + "+matrix"; }
  std::uint64_t fingerprint() const override;
  bool fits() const override { return m_margin > 0 || (m_matrix.radius() == 0 && m_input->fits()); }
  bool pointEvaluable() const override { return m_input->pointEvaluable(); }
  TeStatus accepts(int columns, int rows) const override;
  std::unique_ptr<TeHeightJob> start(const TeMapRequest& request) const override;
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override;

  const TeMatrix& matrix() const { return m_matrix; }
  /// Samples beyond each border that are taken from the input.
  int margin() const { return m_margin; }
  /// The weighted mean of heights h_i with coefficients c_i in order, those that are missing left out.
  /// Missing if the sample itself is.
  float mean(const float* heights, const double* coefficients, int count, float self) const;

private:
  TeMapRequest inputRequest(const TeMapRequest& request) const;

  TeHeightSourcePtr m_input;
  TeMatrix m_matrix;
  int m_margin;
};
