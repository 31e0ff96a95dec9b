#pragma once

#include <cstddef>
#include <vector>

/// The surface over one row of cells of a patch that is drawn at one resolution all over: cells are split
/// along the diagonal toward the patch's centre. Above a column of samples it is two straight lines, which
/// meet on the cell's diagonal.
class TeSeamlessCellRow {
public:
  /// Heights of the vertices south[0], south[stride], … of the southern and northern border, for cells of
  /// `step` samples' distances a side in a patch of `size`. `southern`: in the southern half of the patch.
  void set(const float* south, const float* north, std::ptrdiff_t stride, int size, int step, bool southern);

  /// Largest deviation of samples[first] .. samples[last], counted from the patch's western border, in the
  /// row `y` above the southern border of the cells.
  double deviation(const float* samples, int y, int first, int last) const;

private:
  int m_step = 1;
  std::vector<double> m_south; ///< of the surface, by column of samples
  std::vector<double> m_north;
  std::vector<double> m_lowerSlope; ///< height a row
  std::vector<double> m_upperSlope;
  std::vector<double> m_turn; ///< row in which the diagonal crosses the column
};
