#pragma once

#include "generators/base/TeResult.h"
#include "generators/elevation/TePlainFile.h"
#include "nodes/clipmap/TePyramidFiles.h"
#include "nodes/clipmap/TeSampleRect.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The level files of a pyramid (TePyramidFiles.h), open for reading. Move-only; reading is thread-safe.
class TePyramidReader {
public:
  static constexpr int kMaxLevel = 22;

  static std::uint64_t levelBytes(int level, int bytesPerSample);

  /// Bytes of a sample of a pyramid of colours, by the highest level up to `wholeLevel` whose file has the
  /// size for 3 or for 4. Error: there is none.
  static TeResult<int> colourBytes(const std::string& name, int wholeLevel);

  /// Opens the levels that can be used: the *base* is the highest one up to `wholeLevel` that is there and
  /// has the right size, since lower ones have no sample that it lacks; from it on all up to `maxLevel`, or
  /// to the highest file where maxLevel is -1, as long as none is missing or of a wrong size: that one is
  /// reported in TeLog, once, and nothing above it is used. Error: arguments out of range, or no base.
  static TeResult<TePyramidReader> open(const std::string& name, int bytesPerSample, int wholeLevel,
                                        int maxLevel = -1);

  const std::string& name() const { return m_name; }
  int bytesPerSample() const { return m_bytesPerSample; }
  int baseLevel() const { return m_base; }
  int topLevel() const { return m_base + int(m_files.size()) - 1; }

  /// Reads samples of level baseLevel() .. topLevel(), which the rectangle must not leave. The row at
  /// `rect.y` (row 0 is the southmost) comes first in memory; rows lie rowBytes apart. Error: the file ends
  /// or cannot be read; what was written until then is undefined.
  TeStatus read(int level, const TeSampleRect& rect, unsigned char* samples, std::size_t rowBytes) const;

private:
  TePyramidReader() = default;

  std::string m_name;
  int m_bytesPerSample = 2;
  int m_base = 0;
  std::vector<TePlainFile> m_files; ///< from the base on
};
