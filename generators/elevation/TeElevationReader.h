#pragma once

#include "generators/elevation/TeElevationFile.h"

#include <array>

/// Heights between the posts of an elevation file, bilinear: h = (1-fy)·((1-fx)·h00 + fx·h10) +
/// fy·((1-fx)·h01 + fx·h11) in double, rounded once; posts with weight zero do not count. A height is missing
/// if a post that counts is. On terrain beyond the outermost posts (pixels that are areas) their heights go
/// on. A function of the file and the position alone. Holds the four tiles that it used last; not
/// thread-safe, any number of readers may share a file.
class TeElevationReader {
public:
  explicit TeElevationReader(TeElevationFilePtr file)
      : m_file(std::move(file)), m_sideBits(m_file->tiles().sideBits()) {}

  const TeElevationFile& file() const { return *m_file; }
  /// Tiles taken from the file so far, from its cache or by reading.
  std::int64_t tilesTaken() const { return m_tilesTaken; }

  /// Height at post coordinates; those outside the terrain are taken to its edge, at NaN there is none.
  /// Error: the file cannot be read there.
  TeStatus height(TePlanePoint posts, float& height);
  /// Height of an existing post.
  TeStatus post(int column, int row, float& height);

private:
  /// The tile that holds a post.
  TeStatus tileOf(int column, int row, const TeElevationTile*& tile);

  TeElevationFilePtr m_file;
  int m_sideBits;
  struct Slot {
    int across = -1;
    int down = -1;
    TeElevationTiles::TilePtr tile;
  };
  std::array<Slot, 4> m_slots; ///< by the tiles' parity, so that four tiles around a corner fit
  std::int64_t m_tilesTaken = 0;
};
