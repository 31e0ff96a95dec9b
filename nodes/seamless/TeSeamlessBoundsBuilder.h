#pragma once

#include "nodes/seamless/TeSeamlessBounds.h"
#include "nodes/seamless/TeSeamlessCellRow.h"
#include "nodes/seamless/TeSeamlessFan.h"

#include <cstdint>
#include <vector>

/// Measures what TeSeamlessBounds needs, over bands of rows: all that is drawn of a cell lies in its row of
/// cells. Of cells that are higher than a band the vertices are fetched before.
class TeSeamlessBoundsBuilder {
public:
  /// Bands of as many rows, a power of two, as `memory` bytes hold; 16 at least.
  TeSeamlessBoundsBuilder(const TeSeamlessLayout& layout, std::size_t memory);

  /// Once. Errors: as TeSeamlessBounds::create.
  TeResult<TeSeamlessBounds::Measured> measure(const TeSeamlessBounds::ReadRows& read,
                                               const TeSeamlessBounds::Progress& progress);

private:
  /// A resolution of a tree level that leaves samples out.
  struct Surface {
    int level = 0;
    int index = 0;
    int step = 1; ///< between vertices
    int size = 1; ///< of a patch
    int finest = 1;
  };

  std::vector<Surface> surfaces() const;
  TeStatus fetchVertices(const TeSeamlessBounds::ReadRows& read);
  void keepVertices(int row, const float* samples);
  TeStatus readBand(const TeSeamlessBounds::ReadRows& read, int first);
  void measureBand();
  void measureRanges(int row);
  void measureCells(const Surface& surface, std::int32_t patchX, int south);
  void measureFans(const Surface& surface, std::int32_t patchX, int south);
  void measureFan(const Surface& surface, std::int32_t patchX, int south, bool west);
  void raise(const Surface& surface, std::int32_t patchX, std::int32_t patchY, TeSide side, double deviation);

  bool isTall(int step) const { return step > m_bandRows; }
  const float* bandRow(int row) const { return m_band.data() + std::size_t(row - m_first) * m_width; }
  double vertex(const Surface& surface, int row, int column) const;
  std::size_t diagonalStart(const Surface& surface, std::int32_t patchX, std::int32_t patchY,
                            bool rising) const;

  TeSeamlessLayout m_layout;
  TeSeamlessBounds::Measured m_measured;
  std::size_t m_width; ///< samples a row
  int m_bandRows = 0;
  int m_first = 0;           ///< row of the band's first
  std::vector<float> m_band; ///< m_bandRows + 1 rows
  std::int64_t m_missing = 0;
  /// Vertices of cells higher than a band, 2·m_bandRows samples apart.
  std::vector<float> m_grid;
  int m_gridSide = 0;
  /// By tree level that has such cells: samples on both diagonals of the patches.
  std::vector<std::vector<float>> m_diagonals;

  TeSeamlessCellRow m_cells;
  TeSeamlessFan m_fan;
  std::vector<double> m_diagonal; ///< of the fan in work
};
