#pragma once

#include "apps/terrane-bake/TeRows.h"

#include <memory>
#include <optional>
#include <vector>

/// A square grid of another side over rows of any size: bilinear as TeElevationReader, h =
/// (1-fy)·((1-fx)·h00 + fx·h10) + fy·((1-fx)·h01 + fx·h11). The step is the same in both directions; the
/// longer side of the source fills the square, the shorter lies in its middle, and what is beyond it has the
/// value `outside`, or no data. Holds two rows of the source.
class TeResampledRows final : public TeRows {
public:
  TeResampledRows(std::unique_ptr<TeRows> source, int side, std::optional<double> outside);

  TeStatus read(int row, double* numbers) override;
  /// Steps of the source between samples.
  double step() const { return m_step; }

private:
  /// Where a row or column lies in the source: between post and post + 1. No post: outside.
  struct Place {
    int post = -1;
    double fraction = 0;
  };
  Place place(int index, int posts) const;
  TeStatus sourceRow(int row, const double*& numbers);

  std::unique_ptr<TeRows> m_source;
  double m_step;
  double m_outside;
  std::vector<Place> m_places; ///< by column
  int m_heldRows[2] = {-1, -1};
  std::vector<double> m_held[2]; ///< even rows, odd rows
};
