#pragma once

#include "generators/TeHeightMap.h"
#include "generators/filters/TeBandKernel.h"

#include <vector>

/// A map's samples in rows padded to whole vectors, and the band filter over them in small units of work.
///
/// Rows are filtered as columns of a transposed buffer, so that every recursion runs down a column and
/// vectors hold neighbouring ones. Cost: about 2 reads and writes of the map per pass and direction pair;
/// memory: the padded map and at most 1 MiB.
class TeBandGrid {
public:
  static constexpr int kUnitLines = 128;      ///< recursions side by side in one unit
  static constexpr int kUnitSamples = 256;    ///< steps of each
  static constexpr int kTurnedSamples = 2048; ///< longest rows that stay transposed until they are filtered

  /// Whether a grid of this size is worth its padding; the error says which are not.
  static TeStatus accepts(int width, int height);

  TeBandGrid(int width, int height, const TeBandKernel& kernel = TeBandKernel::best());
  TeBandGrid(const TeBandGrid&) = delete;
  TeBandGrid& operator=(const TeBandGrid&) = delete;

  void load(const TeHeightMap& map, int firstRow, int rows);
  void store(TeHeightMap& map, int firstRow, int rows) const;

  enum class Axis { Rows, Columns };
  /// Begins `passes` passes with the constant k, the first of them with the given axis.
  void begin(float k, int passes, Axis axis = Axis::Rows);
  /// Along which lines the next unit goes.
  Axis axis() const { return m_axis; }
  /// One unit: at most kUnitLines × kUnitSamples samples, there and back if that is all of a line. False when
  /// all passes are complete.
  bool unit();

private:
  /// Lines side by side, and the pieces of a line.
  struct Piece {
    int firstLine, lines, firstSample, samples;
    bool atStart, atEnd;
  };
  bool turnedAtOnce() const { return m_width <= kTurnedSamples; }
  Piece piece() const;
  void unitOfRows(const Piece& piece);
  void unitOfColumns(const Piece& piece);
  void advance(const Piece& piece);
  void sweep(float* row, std::ptrdiff_t step, int count, int width, const float* before) const;

  const TeBandKernel& m_kernel;
  int m_width;
  int m_height;
  int m_stride;
  std::vector<float> m_memory; ///< for what the pointers below point to
  float* m_samples;            ///< aligned to whole vectors, like the next
  float* m_turned;             ///< rows, or a piece of long rows, transposed
  std::vector<float> m_carry;  ///< the last column of the piece before
  bool m_careful = false;      ///< some height is missing or very large

  float m_k = 1;
  int m_passesLeft = 0;
  Axis m_axis = Axis::Rows;
  int m_band = 0;
  bool m_falling = false;
  int m_piece = 0; ///< counted in the direction of the sweep
};
