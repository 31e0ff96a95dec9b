#pragma once

#include "nodes/clipmap/TeClipImage.h"
#include "nodes/clipmap/TeClipResidency.h"
#include "nodes/clipmap/TePyramidTiles.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

/// Texels of one level that have changed.
struct TeClipUpload {
  int level = 0;
  TeSampleRect texels; ///< column and row of the image, from 0 to side() - 1; never across its border
};

/// A clipmap (document 004; Tanner, Migdal and Jones 1998): of each level of a pyramid a window of size ×
/// size samples around the viewer, the whole of the lowest one that is held (the *base*). docs/clipmaps.md.
///
/// Sample (x, y) of a level is texel (x mod side(), y mod side()) of the level's image, so that a window
/// moves by writing new rows and columns over those that it leaves. Windows follow the viewer coarse levels
/// first, within a budget of bytes; a window lags behind by whole rows and columns, all of its samples right,
/// or is not resident. Windows are nested: each lies within the one below. A tile that cannot be read makes
/// its level fail, which TeLog says once; that level and those above are not used any more.
///
/// For one drawing context, in one thread; several may share the tiles. Memory: imageBytes() a level, and one
/// such image on the GPU.
class TeClipWindows {
public:
  static constexpr int kMinSize = 5;
  static constexpr int kMaxSize = 8193;

  struct Statistics {
    std::int64_t samplesUploaded = 0;
    std::int64_t bytesUploaded = 0; ///< in the pyramid's bytes a sample
    std::int64_t windowMoves = 0;   ///< of windows that kept samples
    std::int64_t reloads = 0;       ///< of windows that were filled anew, the first time too
  };

  /// The highest level that is whole in a window of that size: the wholeLevel for TePyramidReader::open().
  static int wholeLevel(int size);

  /// Reads the base. `size` need not be 2^k + 1. `maxLevel`: levels above are not held, and one that is whole
  /// is the base itself; -1 for all. Error: a size out of range or for which the pyramid was not opened
  /// (wholeLevel()), a base that cannot be read, not enough memory.
  static TeResult<std::unique_ptr<TeClipWindows>> create(std::shared_ptr<TePyramidTiles> tiles, int size,
                                                         int maxLevel = -1);

  int baseLevel() const { return m_base; }
  int topLevel() const { return m_base + levels() - 1; }
  int levels() const { return int(m_levels.size()); }
  /// Columns and rows of an image; samples are addressed modulo this. The size, or less if the base is all
  /// there is and smaller.
  int side() const { return m_side; }
  int bytesPerSample() const { return m_bytesPerSample; }
  std::size_t imageBytes() const {
    return std::size_t(m_side) * std::size_t(m_side) * std::size_t(m_bytesPerSample);
  }

  /// Moves the windows toward `centre`, in samples of level `level` (any up to 22; the terrain's finest one,
  /// also where topLevel() is less), reading and uploading at most `budget` bytes of samples, 0 meaning as
  /// many as there are; a budget below one row counts as one row. Centres outside are those next to them; one
  /// that is not finite is ignored. After it, uploads() has what changed.
  void update(glm::dvec2 centre, int level, std::size_t budget);
  /// Whether all windows are where the last update wanted them: another one with that centre changes nothing.
  bool isSettled() const;

  /// What can be drawn now, once uploads() have been made.
  const TeClipResidency& residency() const { return m_residency; }

  /// What has changed since clearUploads(), in order, the base's first image included; a bounded number.
  const std::vector<TeClipUpload>& uploads() const { return m_uploads; }
  void clearUploads() { m_uploads.clear(); }
  /// What a texture needs that has nothing yet.
  std::vector<TeClipUpload> allUploads() const;
  /// The first of an upload's samples; its rows lie rowBytes() apart.
  const unsigned char* samples(const TeClipUpload& upload) const;
  std::size_t rowBytes() const { return std::size_t(m_side) * std::size_t(m_bytesPerSample); }

  /// The bytes of sample (x, y) of a level, which may be below the base; null if it is not held now.
  const unsigned char* sample(int level, std::int32_t x, std::int32_t y) const;
  /// The same for heights of 16 bits, only for samples that are held.
  std::uint16_t height(int level, std::int32_t x, std::int32_t y) const;

  const Statistics& statistics() const { return m_statistics; }

private:
  struct Level {
    TeClipImage image;
    TeSampleRect target;     ///< window that the last update wanted
    std::int64_t motion = 0; ///< samples that came into the target with the last update
  };

  TeClipWindows(std::shared_ptr<TePyramidTiles> tiles, int size, int base, int levels);

  Level& at(int level) { return m_levels[std::size_t(level - m_base)]; }
  const Level& at(int level) const { return m_levels[std::size_t(level - m_base)]; }
  TeSampleRect targetFor(int level, glm::dvec2 centre) const;
  bool isNested(int level) const;
  /// Moves one window, with at most `samples` more; returns how many it took.
  std::int64_t follow(int level, std::int64_t samples);
  /// Where a window that is whole can get to with so many samples and stay whole; the target, if it is too
  /// far for that.
  TeSampleRect partOfTheWay(const Level& moved, int level, std::int64_t samples) const;
  void note(int level, const TeSampleRect& texels);
  void updateResidency();

  std::shared_ptr<TePyramidTiles> m_tiles;
  int m_base;
  int m_side;
  int m_bytesPerSample;
  std::vector<Level> m_levels; ///< from the base on
  TeClipResidency m_residency;
  std::vector<TeClipUpload> m_uploads;
  std::vector<TeSampleRect> m_places; ///< of one follow()
  Statistics m_statistics;
};
