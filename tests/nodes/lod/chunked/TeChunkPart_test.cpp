#include "nodes/lod/chunked/TeChunkPart.h"

#include <gtest/gtest.h>

#include <random>

TEST(TeChunkPart, comesBackFromItsKey) {
  std::mt19937 random(1);
  const auto upTo = [&](std::uint32_t most) { return int(random() % (most + 1)); };
  for (int trial = 0; trial < 1000; trial++) {
    TeChunkPart part;
    part.level = upTo(13);
    part.x = upTo(8191);
    part.y = upTo(8191);
    part.weight = upTo(256);
    part.morphing = upTo(1) != 0;
    for (int& side : part.beyond)
      side = upTo(15);
    const TeChunkPart back = TeChunkPart::of(part.key());
    EXPECT_EQ(back.level, part.level);
    EXPECT_EQ(back.x, part.x);
    EXPECT_EQ(back.y, part.y);
    EXPECT_EQ(back.weight, part.weight);
    EXPECT_EQ(back.morphing, part.morphing);
    EXPECT_EQ(back.beyond, part.beyond);
  }
}
