#pragma once

#include "generators/base/TeResult.h"

/// A grid of stored numbers, read row by row; several channels lie interleaved. NaN where there is no data.
class TeRows {
public:
  virtual ~TeRows() = default;

  int columns() const { return m_columns; }
  int rows() const { return m_rows; }
  int channels() const { return m_channels; }
  /// A row, counted from the north: columns · channels numbers. Rows in ascending order are read once each.
  /// Error: unreadable there.
  virtual TeStatus read(int row, double* numbers) = 0;

protected:
  int m_columns = 0;
  int m_rows = 0;
  int m_channels = 1;
};
