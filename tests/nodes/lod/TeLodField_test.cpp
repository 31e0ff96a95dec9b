#include "nodes/lod/TeLodField.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

std::shared_ptr<TeHeightMap> mapOf(int width, int height) {
  return std::make_shared<TeHeightMap>(TeHeightMap::create(width, height).value());
}

std::string errorOf(std::shared_ptr<const TeHeightMap> map, const TeLodField::Placement& placement = {}) {
  const TeResult<TeLodFieldPtr> field = TeLodField::create(std::move(map), placement);
  return field ? std::string() : field.error().message;
}

} // namespace

TEST(TeLodField, SamplesLieWhereThePlacementSays) {
  const auto map = mapOf(5, 5);
  map->at(3, 1) = 7;
  map->at(0, 4) = -2;
  TeLodField::Placement placement;
  placement.corner = {100, -200, 10};
  placement.spacing = 2.5;
  placement.heightScale = 0.5;
  const TeLodFieldPtr field = TeLodField::create(map, placement).value();
  EXPECT_EQ(field->cells(), 4);
  EXPECT_EQ(field->cellsLog(), 2);
  EXPECT_EQ(field->lowest(), -2);
  EXPECT_EQ(field->highest(), 7);
  EXPECT_EQ(field->position(field->vertex(3, 1)), glm::dvec3(107.5, -197.5, 13.5));
}

TEST(TeLodField, SidesAreOneMoreThanAPowerOfTwo) {
  for (int side = 1; side <= 40; side++) {
    const int cells = side - 1;
    const bool fits = cells >= 2 && (cells & (cells - 1)) == 0;
    EXPECT_EQ(errorOf(mapOf(side, side)).empty(), fits) << side;
  }
  EXPECT_NE(errorOf(mapOf(5, 9)).find("5 × 9"), std::string::npos);
  EXPECT_FALSE(errorOf(nullptr).empty());
  EXPECT_FALSE(errorOf(std::make_shared<TeHeightMap>()).empty());
}

TEST(TeLodField, EverySampleHasAFiniteHeight) {
  for (const float bad : {TeHeightMap::missing(), std::numeric_limits<float>::infinity()}) {
    const auto map = mapOf(9, 9);
    map->at(8, 5) = bad;
    EXPECT_NE(errorOf(map).find("(8, 5)"), std::string::npos) << errorOf(map);
  }
}

TEST(TeLodField, ThePlacementIsInRange) {
  const double infinite = std::numeric_limits<double>::infinity();
  TeLodField::Placement far, still, flat, sunk;
  far.corner.y = infinite;
  still.spacing = 0;
  sunk.heightScale = -1;
  flat.heightScale = 0;
  EXPECT_NE(errorOf(mapOf(3, 3), far).find("corner"), std::string::npos);
  EXPECT_NE(errorOf(mapOf(3, 3), still).find("spacing"), std::string::npos);
  EXPECT_NE(errorOf(mapOf(3, 3), sunk).find("scale"), std::string::npos);
  EXPECT_TRUE(errorOf(mapOf(3, 3), flat).empty());
}
