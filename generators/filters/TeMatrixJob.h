#pragma once

#include "generators/TeHeightSource.h"
#include "generators/filters/TeMatrixSource.h"

#include <memory>
#include <vector>

/// A TeMatrixSource's map in the making: the input's job, then runs of samples of a row.
class TeMatrixJob final : public TeHeightJob {
public:
  TeMatrixJob(std::shared_ptr<const TeMatrixSource> source, std::unique_ptr<TeHeightJob> input);

protected:
  TeProgress unit() override;

private:
  TeProgress unitOfInput();
  /// Where the whole matrix is at hand: sums of vectors, with the bits of mean().
  void inside(int column, int count, float* heights);
  /// One sample by mean().
  float single(int column) const;

  std::shared_ptr<const TeMatrixSource> m_source;
  std::unique_ptr<TeHeightJob> m_input;
  TeHeightMap m_before;
  std::vector<double> m_sums;
  double m_whole = 0; ///< sum of all coefficients
  int m_column = 0;   ///< the next sample of m_map
  int m_row = 0;
};
