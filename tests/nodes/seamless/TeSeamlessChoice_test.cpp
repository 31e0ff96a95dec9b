#include "nodes/seamless/TeSeamlessChoice.h"

#include "nodes/seamless/hillsNode.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

/// Hills of 256 cells, 4 m each, from an eye that sees everything.
class TeSeamlessChoiceTest : public testing::Test {
protected:
  TeSeamlessChoiceTest() {
    const auto layout = TeSeamlessLayout::create(256, 8, 3);
    m_terrain = *TeSeamlessTerrain::create(*layout, std::make_shared<const TeHeightMap>(hillsMap(256)));
    m_placement.spacing = 4;
    m_placement.range = m_terrain->range;
    m_view.eye = {500, 300, 250};
    m_view.focal = 600;
  }
  bool update(const TeClipResidency* residency = nullptr) {
    return m_choice.update(m_terrain, m_terrain->parts, m_view, m_placement, m_accuracy, residency);
  }

  TeSeamlessTerrainPtr m_terrain;
  TeSeamlessPlacement m_placement;
  TeSeamlessAccuracy m_accuracy;
  TeLodView m_view;
  TeSeamlessChoice m_choice;
};

} // namespace

TEST_F(TeSeamlessChoiceTest, ChoosesAgainOnlyIfSomethingHasChanged) {
  EXPECT_TRUE(update());
  EXPECT_GT(m_choice.selection().patches.size(), 1u);
  EXPECT_GT(m_choice.lists().draws().size(), 0u);
  EXPECT_FALSE(update());
  m_accuracy.precision = 3;
  EXPECT_TRUE(update());
  EXPECT_FALSE(update());
  m_placement.corner.x = 0.5;
  EXPECT_TRUE(update());
  m_view.planes[0] = {1, 0, 0, -300};
  m_view.planeCount = 1;
  EXPECT_TRUE(update());
  EXPECT_FALSE(update());
  TeClipResidency residency;
  residency.base = 8;
  residency.windows.resize(1);
  residency.windows[0].side = 257;
  EXPECT_TRUE(update(&residency));
  EXPECT_FALSE(update(&residency));
  residency.windows[0].side = 256;
  EXPECT_TRUE(update(&residency));
  EXPECT_TRUE(update());
  EXPECT_EQ(m_choice.selections(), 7u);
}

TEST_F(TeSeamlessChoiceTest, HoldsTheEyeWithinItsRadius) {
  const glm::dvec3 start = m_view.eye;
  EXPECT_TRUE(update());
  EXPECT_EQ(m_choice.view().eye, start);
  EXPECT_EQ(m_choice.view().slack, 2); // half of 4 m
  m_view.eye = start + glm::dvec3(1.9, 0, 0);
  EXPECT_FALSE(update());
  m_view.eye = start - glm::dvec3(0, 0, 1.9);
  EXPECT_FALSE(update());
  m_view.eye = start + glm::dvec3(2.1, 0, 0);
  EXPECT_TRUE(update());
  EXPECT_EQ(m_choice.view().eye, m_view.eye);
}

TEST_F(TeSeamlessChoiceTest, HoldsNothingWhereItWouldBeOfNoUse) {
  m_accuracy.geomorph = true;
  EXPECT_TRUE(update());
  EXPECT_EQ(m_choice.view().slack, 0);
  m_view.eye.x += 0.001;
  EXPECT_TRUE(update());
  m_accuracy.geomorph = false;
  m_view.perspective = false;
  EXPECT_TRUE(update());
  EXPECT_EQ(m_choice.view().slack, 0);
}

// The stated bound is true for every eye for which the held one stands.
TEST_F(TeSeamlessChoiceTest, BoundIsNoLessThanThatOfTheTrueEye) {
  std::mt19937 numbers(8);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 20; i++) {
    m_view.eye = {512 + 400 * number(numbers), 512 + 400 * number(numbers), 180 + 30 * number(numbers)};
    m_accuracy.pixelError = 3;
    EXPECT_TRUE(update());
    const double stated = m_choice.selection().errorBound;
    EXPECT_LE(stated, 3);
    const glm::dvec3 start = m_view.eye;
    for (int j = 0; j < 5; j++) {
      glm::dvec3 step(number(numbers), number(numbers), number(numbers));
      m_view.eye = start + step * (1.99 / glm::length(step));
      EXPECT_FALSE(update());
      // The same patches at the same details, seen from the true eye.
      double worst = 0;
      for (const TeSeamlessPatch& patch : m_choice.selection().patches) {
        for (int side = 0; side < 4; side++) {
          const TeSideKey key = TeSeamlessLayout::sideOf(patch.level, patch.x, patch.y, TeSide(side));
          const TeSideBounds bounds = m_terrain->selector.bounds()->side(key);
          const double cells = m_terrain->layout.cells(patch.level);
          const glm::dvec3 low(patch.x * cells * 4, patch.y * cells * 4, double(bounds.range.low));
          const glm::dvec3 high =
              low + glm::dvec3(cells * 4, cells * 4, double(bounds.range.high - bounds.range.low));
          const double distance =
              glm::length(glm::max(glm::max(low - m_view.eye, m_view.eye - high), glm::dvec3(0)));
          // Of the patch alone, not of both at the side.
          const double farthest = distance + cells * 4;
          worst = std::max(worst, m_view.pixels(double(bounds.error[patch.resolution(side)]), farthest));
        }
      }
      EXPECT_LE(worst, stated);
    }
  }
}
