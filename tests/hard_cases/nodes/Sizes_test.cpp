#include "nodes/terrain/SoTeStaticTerrain.h"

#include "nodes/askScene.h"

#include <Inventor/errors/SoDebugError.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

// Every size is drawn whole or refused with one line.
TEST(HardCase, SizesNodes) {
  int warnings = 0;
  SoErrorCB* const handler = SoDebugError::getHandlerCallback();
  void* const data = SoDebugError::getHandlerData();
  SoDebugError::setHandlerCallback([](const SoError*, void* count) { ++*static_cast<int*>(count); },
                                   &warnings);
  const TeNodePtr<SoTeStaticTerrain> terrain(new SoTeStaticTerrain);
  terrain->generator = "noise";
  int drawn = 0;
  int refused = 0;
  const auto tryOut = [&](int samples, int block) {
    terrain->samples = samples;
    terrain->block = block;
    warnings = 0;
    const int count = triangles(terrain.get());
    if (samples >= 5 && samples <= 16385 && samples % 2 == 1 && block >= 1 && block < 1000) {
      const int side = block * ((samples - 1) / 2) - 2;
      EXPECT_EQ(count, 2 * side * side) << samples << " " << block;
      EXPECT_EQ(warnings, 0) << samples << " " << block;
      drawn++;
    } else {
      EXPECT_EQ(count, 0) << samples << " " << block;
      EXPECT_EQ(warnings, 1) << samples << " " << block;
      refused++;
    }
  };
  for (int samples = 0; samples <= 70; samples++)
    tryOut(samples, 2);
  for (int block : {-1, 0, 1, 2, 3, 7, 10})
    tryOut(17, block);
  const int huge = std::numeric_limits<int>::max();
  for (const auto& [samples, block] : {std::pair(huge, 1), {65, huge}, {-huge, -huge}, {16385, 1000}})
    tryOut(samples, block);
  SoDebugError::setHandlerCallback(handler, data);
  std::printf("HardCase.SizesNodes: %d sizes drawn whole, %d refused with one line\n", drawn, refused);
}
