#pragma once

#include "nodes/clipmap/TePyramidFiles.h"
#include "nodes/clipmap/TePyramidReader.h"
#include "nodes/clipmap/TePyramidTiles.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

/// The level files of a pyramid in a folder of its own, removed in the end. All bytes of a sample follow from
/// its place, so that a sample in a wrong place is found.
class TestPyramid {
public:
  TestPyramid(int top, int bytesPerSample = 2) : m_top(top), m_bytesPerSample(bytesPerSample) {
    static int number = 0;
    m_folder = testing::TempDir() + "pyramid-" + std::to_string(::getpid()) + "-" + std::to_string(number++);
    std::filesystem::create_directories(m_folder);
    for (int level = 0; level <= top; level++)
      write(level);
  }
  ~TestPyramid() { std::filesystem::remove_all(m_folder); }
  TestPyramid(const TestPyramid&) = delete;
  TestPyramid& operator=(const TestPyramid&) = delete;

  std::string folder() const { return m_folder; }
  std::string name() const { return m_folder + "/p"; }
  std::string file(int level) const { return tePyramidLevelFile(name(), level); }
  int top() const { return m_top; }

  /// The bytes of a sample, the first one lowest. Row 0 is in the south.
  std::uint32_t sample(int level, std::int32_t x, std::int32_t y) const {
    const auto column = std::uint32_t(x) << (m_top - level);
    const auto row = std::uint32_t(y) << (m_top - level);
    std::uint32_t hash = column * 2654435761u ^ (row + 77) * 2246822519u;
    hash = (hash ^ hash >> 15) * 3266489917u;
    hash ^= hash >> 16;
    return m_bytesPerSample == 4 ? hash : hash & ((1u << 8 * m_bytesPerSample) - 1);
  }
  bool isSample(const unsigned char* bytes, int level, std::int32_t x, std::int32_t y) const {
    const std::uint32_t expected = sample(level, x, y);
    for (int i = 0; i < m_bytesPerSample; i++)
      if (bytes[i] != (expected >> 8 * i & 255))
        return false;
    return true;
  }

  void write(int level) const {
    std::string bytes;
    const int side = tePyramidSide(level);
    for (int y = side - 1; y >= 0; y--)
      for (int x = 0; x < side; x++)
        for (int i = 0; i < m_bytesPerSample; i++)
          bytes.push_back(char(sample(level, x, y) >> 8 * i & 255));
    std::ofstream(file(level), std::ios::binary) << bytes;
  }
  void resize(int level, std::uintmax_t bytes) const { std::filesystem::resize_file(file(level), bytes); }

  std::shared_ptr<TePyramidTiles> tiles(int wholeLevel,
                                        std::size_t cacheBytes = TePyramidTiles::kDefaultCacheBytes) const {
    TeResult<TePyramidReader> reader = TePyramidReader::open(name(), m_bytesPerSample, wholeLevel);
    if (!reader) {
      ADD_FAILURE() << reader.error().message;
      return nullptr;
    }
    return std::make_shared<TePyramidTiles>(std::move(*reader), cacheBytes);
  }

private:
  int m_top;
  int m_bytesPerSample;
  std::string m_folder;
};
