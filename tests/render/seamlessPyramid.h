#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/clipmap/TeClipmapTexture.h"
#include "nodes/clipmap/TePyramidFiles.h"
#include "nodes/seamless/TeSeamlessClipTexture.h"
#include "nodes/seamless/TeSeamlessMesh.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

/// The level files of a height map, or of its colours, in a folder of their own; and a clipmap over them in
/// the current context.
class SeamlessPyramid {
public:
  /// Heights are rounded to whole numbers 0 .. 65535; `colours`: grey for heights, three bytes.
  SeamlessPyramid(const TeHeightMap& map, int clipSize, TeClipFormat format)
      : m_map(map), m_colours(format == TeClipFormat::Colour), m_level(tePyramidLevelOfSide(map.width())),
        m_texture(std::make_unique<TeClipmapTexture>(0, format)) {
    static int number = 0;
    m_folder = testing::TempDir() + "seamless-" + std::to_string(::getpid()) + "-" + std::to_string(number++);
    std::filesystem::create_directories(m_folder);
    for (int level = 0; level <= m_level; level++)
      write(level);
    auto reader =
        TePyramidReader::open(m_folder + "/p", m_colours ? 3 : 2, TeClipWindows::wholeLevel(clipSize));
    EXPECT_TRUE(reader) << (reader ? "" : reader.error().message);
    auto windows = TeClipWindows::create(
        std::make_shared<TePyramidTiles>(std::move(*reader), std::size_t(1) << 20), clipSize);
    EXPECT_TRUE(windows) << (windows ? "" : windows.error().message);
    m_windows = std::move(*windows);
  }
  ~SeamlessPyramid() { std::filesystem::remove_all(m_folder); }
  SeamlessPyramid(const SeamlessPyramid&) = delete;
  SeamlessPyramid& operator=(const SeamlessPyramid&) = delete;

  /// With the context current, which Coin knows by this number.
  void update(std::uint32_t context, glm::dvec2 centre) {
    if (!m_isMade)
      m_texture = std::make_unique<TeClipmapTexture>(context, m_texture->format());
    m_isMade = true;
    m_windows->update(centre, m_level, 0);
    const TeStatus status = m_texture->update(*m_windows);
    EXPECT_TRUE(status) << (status ? "" : status.error().message);
    clipmap = TeSeamlessClipTexture::of(*m_texture, *m_windows, m_level);
  }
  void free() { m_texture->free(); }
  int level() const { return m_level; }

  /// What shaders read for a sample of the finest level, from the level that it is drawn of.
  float drawnHeight(std::int32_t column, std::int32_t row, int heightLevel) const {
    const int level = std::max(heightLevel, m_windows->baseLevel());
    EXPECT_TRUE(m_windows->residency().holds(level, column >> (m_level - level), row >> (m_level - level),
                                             column >> (m_level - level), row >> (m_level - level)));
    return teDrawnHeight(m_windows->height(level, column >> (m_level - level), row >> (m_level - level)),
                         m_texture->format());
  }

  TeSeamlessClipTexture clipmap;

private:
  void write(int level) const {
    std::string bytes;
    const int side = tePyramidSide(level);
    for (int y = side - 1; y >= 0; y--)
      for (int x = 0; x < side; x++) {
        const float height = m_map.at(x << (m_level - level), y << (m_level - level));
        const long value = std::lround(std::fmin(std::fmax(height, 0), 65535));
        bytes.push_back(char(value & 255));
        bytes.push_back(char(m_colours ? value & 255 : value >> 8));
        if (m_colours)
          bytes.push_back(char(value & 255));
      }
    std::ofstream(tePyramidLevelFile(m_folder + "/p", level), std::ios::binary) << bytes;
  }

  const TeHeightMap& m_map;
  bool m_colours;
  int m_level;
  bool m_isMade = false;
  std::string m_folder;
  std::unique_ptr<TeClipWindows> m_windows;
  std::unique_ptr<TeClipmapTexture> m_texture;
};

/// The heights that a clipmap has, for TeSeamlessMesh.
class SeamlessClipHeights : public TeSeamlessHeights {
public:
  explicit SeamlessClipHeights(const SeamlessPyramid& pyramid) : m_pyramid(pyramid) {}
  float height(std::int32_t column, std::int32_t row, int heightLevel) const override {
    return m_pyramid.drawnHeight(column, row, heightLevel);
  }

private:
  const SeamlessPyramid& m_pyramid;
};
