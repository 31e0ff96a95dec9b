#pragma once

#include "nodes/clipmap/TeClipWindows.h"

#include <glm/vec2.hpp>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

/// The level files that clip windows of 513 × 513 samples need of a pyramid up to level 12, in the temporary
/// folder until the program ends.
class ClipmapPyramid {
public:
  static constexpr int kTop = 12;
  static constexpr int kSize = 513;

  /// Windows over tiles of their own.
  static std::unique_ptr<TeClipWindows> windows(std::size_t cacheBytes) {
    static const ClipmapPyramid pyramid;
    auto reader = TePyramidReader::open(pyramid.m_folder + "/p", 2, TeClipWindows::wholeLevel(kSize));
    if (!reader)
      std::abort();
    auto tiles = std::make_shared<TePyramidTiles>(std::move(*reader), cacheBytes);
    auto made = TeClipWindows::create(tiles, kSize);
    if (!made)
      std::abort();
    return std::move(*made);
  }

private:
  ClipmapPyramid()
      : m_folder((std::filesystem::temp_directory_path() / ("clipmap-bench-" + std::to_string(::getpid())))
                     .string()) {
    std::filesystem::create_directories(m_folder);
    for (int level = TeClipWindows::wholeLevel(kSize); level <= kTop; level++) {
      const int side = tePyramidSide(level);
      std::string row(std::size_t(side) * 2, ' ');
      std::ofstream file(tePyramidLevelFile(m_folder + "/p", level), std::ios::binary);
      for (int y = 0; y < side; y++) {
        for (std::size_t x = 0; x < row.size(); x++)
          row[x] = char(x * 7919 + std::size_t(y) * 104729);
        file << row;
      }
    }
  }
  ~ClipmapPyramid() { std::filesystem::remove_all(m_folder); }

  std::string m_folder;
};

/// Back and forth over the pyramid, not along an axis, by so many samples of the finest level at a time.
class ClipmapFlight {
public:
  explicit ClipmapFlight(double samples) : m_step(samples, samples * 0.25) {}
  glm::dvec2 next() {
    const glm::dvec2 ahead = m_at + m_step;
    if (ahead.x < 600 || ahead.x > 3500)
      m_step = -m_step;
    m_at += m_step;
    return m_at;
  }

private:
  glm::dvec2 m_at{1000, 1000};
  glm::dvec2 m_step;
};
