#include "nodes/clipmap/TePyramidReader.h"

#include "generators/base/TeLog.h"

#include <algorithm>
#include <cassert>
#include <filesystem>

namespace {

const char* const kNoName = "the name of a pyramid of level files is empty";

TeResult<TePlainFile> openLevel(const std::string& name, int bytesPerSample, int level) {
  const std::string path = tePyramidLevelFile(name, level);
  TeResult<TePlainFile> file = TePlainFile::open(path);
  if (!file)
    return file;
  const std::uint64_t expected = TePyramidReader::levelBytes(level, bytesPerSample);
  if (file->bytes() == expected)
    return file;
  const std::string side = std::to_string(tePyramidSide(level));
  return TeError{path + ": " + std::to_string(file->bytes()) + " bytes instead of the " +
                 std::to_string(expected) + " of " + side + "x" + side + " samples of " +
                 std::to_string(bytesPerSample) + " bytes"};
}

bool exists(const std::string& name, int level) {
  std::error_code ignored;
  return std::filesystem::exists(tePyramidLevelFile(name, level), ignored);
}

/// The highest level in [from, to] of which there is a file, of whatever kind; -1 if there is none.
int highestFile(const std::string& name, int from, int to) {
  int level = to;
  while (level >= from && !exists(name, level))
    level--;
  return level >= from ? level : -1;
}

} // namespace

std::uint64_t TePyramidReader::levelBytes(int level, int bytesPerSample) {
  const auto side = std::uint64_t(tePyramidSide(level));
  return side * side * std::uint64_t(bytesPerSample);
}

TeResult<int> TePyramidReader::colourBytes(const std::string& name, int wholeLevel) {
  if (name.empty())
    return TeError{kNoName};
  TeError error{tePyramidLevelFile(name, 0) + ": there is neither this file nor one of a higher level"};
  for (int level = wholeLevel; level >= 0; level--) {
    for (int bytes : {4, 3}) {
      const TeResult<TePlainFile> file = openLevel(name, bytes, level);
      if (file)
        return bytes;
      if (exists(name, level))
        error = file.error();
    }
  }
  return error;
}

TeResult<TePyramidReader> TePyramidReader::open(const std::string& name, int bytesPerSample, int wholeLevel,
                                                int maxLevel) {
  if (name.empty())
    return TeError{kNoName};
  if (bytesPerSample < 2 || bytesPerSample > 4)
    return TeError{name + ": samples of " + std::to_string(bytesPerSample) +
                   " bytes; heights have 2, colours 3 or 4"};
  if (maxLevel < -1 || maxLevel > kMaxLevel)
    return TeError{name + ": highest level " + std::to_string(maxLevel) + " is not from 0 to " +
                   std::to_string(kMaxLevel) + ", or -1 for all"};
  if (wholeLevel < 0 || wholeLevel > kMaxLevel)
    return TeError{name + ": level " + std::to_string(wholeLevel) + " is not from 0 to " +
                   std::to_string(kMaxLevel)};

  TePyramidReader reader;
  reader.m_name = name;
  reader.m_bytesPerSample = bytesPerSample;
  const int wanted = maxLevel >= 0 ? maxLevel : highestFile(name, 0, kMaxLevel);
  if (wanted < 0)
    return TeError{tePyramidLevelFile(name, 0) + ": there is neither this file nor one of a higher level"};
  std::string reason; // why the lowest of the levels that are not used is not
  for (int level = std::min(wholeLevel, wanted); level >= 0 && reader.m_files.empty(); level--) {
    TeResult<TePlainFile> file = openLevel(name, bytesPerSample, level);
    if (file)
      reader.m_files.push_back(std::move(*file));
    else
      reason = file.error().message;
    reader.m_base = level;
  }
  if (reader.m_files.empty())
    return TeError{"no level of the pyramid can be used: " + reason};
  for (int level = reader.m_base + 1; level <= wanted && reason.empty(); level++) {
    TeResult<TePlainFile> file = openLevel(name, bytesPerSample, level);
    if (file)
      reader.m_files.push_back(std::move(*file));
    else
      reason = file.error().message;
  }
  if (!reason.empty())
    TeLog::warning(reason + "; level " + std::to_string(reader.topLevel()) + " stands for it" +
                   (wanted > reader.topLevel() + 1 ? " and those above" : ""));
  return reader;
}

TeStatus TePyramidReader::read(int level, const TeSampleRect& rect, unsigned char* samples,
                               std::size_t rowBytes) const {
  const std::int32_t side = tePyramidSide(level);
  assert(level >= baseLevel() && level <= topLevel());
  assert(rect.x >= 0 && rect.y >= 0 && rect.columns <= side - rect.x && rect.rows <= side - rect.y);
  const TePlainFile& file = m_files[std::size_t(level - m_base)];
  const std::size_t bytes = std::size_t(rect.columns) * std::size_t(m_bytesPerSample);
  // By rows of the file, so that it is read forward.
  for (std::int32_t row = rect.rows - 1; row >= 0; row--) {
    const std::int64_t fromNorth = side - 1 - (rect.y + row);
    const std::int64_t first = fromNorth * side + rect.x;
    unsigned char* to = samples + std::size_t(row) * rowBytes;
    if (TeStatus ok = file.read(std::uint64_t(first * m_bytesPerSample), to, bytes); !ok)
      return ok;
  }
  return {};
}
