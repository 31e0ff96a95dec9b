#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/TeNodePtr.h"
#include "nodes/clipmap/TePyramidFiles.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"

#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>

/// Hills of 55 to 145 m, as whole numbers of 16 bits when taken `times` as high.
inline TeHeightMap hillsMap(int resolution, double times = 1) {
  TeHeightMap map = std::move(TeHeightMap::create(resolution + 1, resolution + 1).value());
  for (int y = 0; y <= resolution; y++) {
    for (int x = 0; x <= resolution; x++) {
      const double u = double(x) / resolution, v = double(y) / resolution;
      const double metres = 100 + 35 * std::sin(28 * u) * std::cos(18 * v + 1) +
                            10 * std::sin(90 * u + 40 * v) * std::cos(100 * v);
      map.at(x, y) = times == 1 ? float(metres) : float(std::round(metres * times));
    }
  }
  return map;
}

/// Hills on a square of `side` metres around (0, 0).
inline TeNodePtr<SoTeSeamlessPatches> hillsNode(int resolution = 256, float side = 1000) {
  TeNodePtr<SoTeSeamlessPatches> node(new SoTeSeamlessPatches);
  node->size.setValue(side, side, 0);
  node->resolution = 0;
  node->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
  node->setHeights(std::make_shared<const TeHeightMap>(hillsMap(resolution)));
  return node;
}

/// The level files of hills, 100 times as high, in a folder of their own; or of their colours.
class HillsPyramid {
public:
  explicit HillsPyramid(int resolution, bool colours = false) : m_map(hillsMap(resolution, 100)) {
    static int number = 0;
    m_folder = testing::TempDir() + "hills-" + std::to_string(::getpid()) + "-" + std::to_string(number++);
    std::filesystem::create_directories(m_folder);
    m_top = tePyramidLevelOfSide(m_map.width());
    for (int level = 0; level <= m_top; level++)
      write(level, colours);
  }
  ~HillsPyramid() { std::filesystem::remove_all(m_folder); }
  HillsPyramid(const HillsPyramid&) = delete;
  HillsPyramid& operator=(const HillsPyramid&) = delete;

  std::string name() const { return m_folder + "/hills"; }
  int top() const { return m_top; }
  const TeHeightMap& map() const { return m_map; }

  /// Hills as hillsNode() has them, read through clip windows.
  TeNodePtr<SoTeSeamlessPatches> node(int clipSize, float side = 1000, int budget = 1 << 20) const {
    TeNodePtr<SoTeSeamlessPatches> node(new SoTeSeamlessPatches);
    node->size.setValue(side, side, 655.35f);
    node->resolution = 0;
    node->heightSource = SoTeSeamlessPatches::CLIPMAPS;
    auto* clipmap = new SoTeClipmap;
    clipmap->name = name().c_str();
    clipmap->size = clipSize;
    clipmap->uploadBudget = budget;
    node->heights = clipmap;
    return node;
  }

private:
  void write(int level, bool colours) const {
    std::string bytes;
    const int side = tePyramidSide(level);
    for (int y = side - 1; y >= 0; y--) {
      for (int x = 0; x < side; x++) {
        const int number = int(m_map.at(x << (m_top - level), y << (m_top - level)));
        if (colours) {
          bytes.push_back(char(x * 255 / (side - 1)));
          bytes.push_back(char(y * 255 / (side - 1)));
          bytes.push_back(char(0));
        } else {
          bytes.push_back(char(number & 255));
          bytes.push_back(char(number >> 8));
        }
      }
    }
    std::ofstream(tePyramidLevelFile(name(), level), std::ios::binary) << bytes;
  }

  TeHeightMap m_map;
  int m_top = 0;
  std::string m_folder;
};

inline TeNodePtr<SoSeparator> seenBy(const SbVec3f& position, const SbVec3f& target, SoNode* node) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  auto* camera = new SoPerspectiveCamera;
  camera->position = position;
  camera->pointAt(target, SbVec3f(0, 0, 1));
  camera->nearDistance = 1;
  camera->farDistance = 5000;
  root->addChild(camera);
  root->addChild(node);
  return root;
}
