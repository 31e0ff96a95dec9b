#include "nodes/seamless/TeSeamlessSlopeColours.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

TEST(TeSeamlessSlopeColours, LevelGroundShowsEveryLayerFromPebblesToSnow) {
  const TeSeamlessSlopeColours colours = TeSeamlessSlopeColours::forHeights(-100, 900);
  const float heights[] = {-100, -30, 200, 550, 900};
  for (std::size_t i = 0; i < 5; i++)
    EXPECT_LT(glm::distance(colours.colour(heights[i], 0), colours.layers[i].colour), 0.01f) << i;
}

TEST(TeSeamlessSlopeColours, SteepGroundIsGravelAtAnyHeight) {
  const TeSeamlessSlopeColours colours = TeSeamlessSlopeColours::forHeights(0, 1000);
  const glm::vec3 gravel = colours.layers[TeSeamlessSlopeColours::Gravel].colour;
  for (float height = 0; height <= 1000; height += 50)
    EXPECT_LT(glm::distance(colours.colour(height, 5), gravel), 0.01f) << height;
}

TEST(TeSeamlessSlopeColours, ChangesWithoutAJump) {
  for (const TeSeamlessSlopeColours& colours :
       {TeSeamlessSlopeColours(), TeSeamlessSlopeColours::forHeights(0, 3000)}) {
    for (float height = -100; height < 3100; height++)
      EXPECT_LT(glm::distance(colours.colour(height, 0.3f), colours.colour(height + 1, 0.3f)), 0.03f)
          << height;
    for (float slope = 0; slope < 3; slope += 0.01f)
      EXPECT_LT(glm::distance(colours.colour(1000, slope), colours.colour(1000, slope + 0.01f)), 0.03f)
          << slope;
  }
}

TEST(TeSeamlessSlopeColours, AFlatTerrainHasAColourToo) {
  const glm::vec3 colour = TeSeamlessSlopeColours::forHeights(7, 7).colour(7, 0);
  EXPECT_TRUE(colour.x >= 0 && colour.x <= 1 && colour.y >= 0 && colour.y <= 1);
}
