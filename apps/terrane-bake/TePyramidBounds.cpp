#include "apps/terrane-bake/TePyramidBounds.h"

#include "generators/base/TePartFile.h"
#include "nodes/clipmap/TePyramidReader.h"
#include "nodes/seamless/TeSeamlessBoundsFile.h"

#include <filesystem>
#include <system_error>

namespace {

constexpr std::size_t kMemoryBytes = std::size_t(8) << 20;

/// Rows of 16 bits as numbers.
TeStatus readRows(const TePyramidReader& files, int row, int count, std::vector<unsigned char>& bytes,
                  float* samples) {
  const int level = files.topLevel();
  const int side = tePyramidSide(level);
  bytes.resize(2 * std::size_t(side));
  for (int y = row; y < row + count; ++y) {
    if (TeStatus ok = files.read(level, {0, y, side, 1}, bytes.data(), bytes.size()); !ok)
      return ok;
    for (std::size_t i = 0; i < bytes.size(); i += 2)
      *samples++ = float(unsigned(bytes[i]) | unsigned(bytes[i + 1]) << 8);
  }
  return {};
}

} // namespace

TeResult<std::string> teWritePyramidBounds(const std::string& name, const TeSeamlessLayout& layout,
                                           const std::function<void(double)>& progress) {
  const int level = layout.resolutionLog();
  const TeResult<TePyramidReader> files = TePyramidReader::open(name, 2, level, level);
  if (!files)
    return files.error();
  if (files->topLevel() != level)
    return TeError{tePyramidLevelFile(name, level) + ": cannot be read"};
  std::vector<unsigned char> bytes;
  const auto bounds = TeSeamlessBounds::create(
      layout,
      [&](int row, int count, float* samples) { return readRows(*files, row, count, bytes, samples); },
      [&](double done) {
        progress(done);
        return true;
      },
      kMemoryBytes);
  if (!bounds)
    return bounds.error();
  const std::string file = TeSeamlessBoundsFile::nameFor(name, layout);
  if (TeStatus ok = TeSeamlessBoundsFile::save(**bounds, file); !ok)
    return ok.error();
  return file;
}

std::vector<std::string> tePyramidBoundsBeside(const std::string& name) {
  std::vector<std::string> files;
  for (int resolution = 2; resolution <= TeSeamlessLayout::kMaxPatchResolution; resolution *= 2)
    for (int levels = 2; levels <= TeSeamlessLayout::kMaxLevels; ++levels) {
      const auto layout = TeSeamlessLayout::create(TeSeamlessLayout::kMaxResolution, resolution, levels);
      if (!layout)
        continue;
      const std::string bounds = TeSeamlessBoundsFile::nameFor(name, *layout);
      std::error_code ignored;
      for (const std::string& file : {bounds, TePartFile::partOf(bounds)})
        if (std::filesystem::exists(std::filesystem::symlink_status(file, ignored)))
          files.push_back(file);
    }
  return files;
}
