#include "generators/function/TeFunctionGenerator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

TEST(TeFunctionGenerator, IsTheFunctionOfWorldCoordinates) {
  TeFunctionGenerator generator;
  generator.z = "x + y/1024";
  ASSERT_TRUE(generator.updateParams().ok());
  const TeLattice lattice = TeLattice::create(17, 2.5).value();
  for (const TeMapKey& key : {TeMapKey{0, 0}, TeMapKey{-3, 5}}) {
    const TeMapRequest request = TeMapRequest::sourceMap(lattice, 1, key);
    const TeHeightMap map = generator.source()->generate(request).value();
    for (int y = 0; y < 17; ++y)
      for (int x = 0; x < 17; ++x)
        ASSERT_EQ(map.at(x, y), float(lattice.position(lattice.mapFirstSample(key.x) + x) +
                                      lattice.position(lattice.mapFirstSample(key.y) + y) / 1024));
  }
  EXPECT_TRUE(generator.source()->fits());
  EXPECT_TRUE(generator.source()->pointEvaluable());
}

TEST(TeFunctionGenerator, TakesAProgramsOwnFunction) {
  TeFunctionGenerator generator;
  generator.function = [](double x, double y) { return x * y; };
  const TeStatus nameless = generator.updateParams();
  ASSERT_FALSE(nameless.ok());
  EXPECT_EQ(nameless.error().message, "function: a function of the program's own needs a functionName");
  generator.functionName = "product";
  ASSERT_TRUE(generator.updateParams().ok());
  const TeHeightSourcePtr product = generator.source();
  EXPECT_EQ(product->generate(TeMapRequest::standalone(5, 5, 2, 0).value()).value().at(3, 4), 6.0f * 8.0f);
  generator.functionName = "other";
  ASSERT_TRUE(generator.updateParams().ok());
  EXPECT_NE(generator.source()->fingerprint(), product->fingerprint());
}

TEST(TeFunctionGenerator, WhatIsNotFiniteIsMissing) {
  TeFunctionGenerator generator;
  generator.functionName = "wild";
  const double wild[] = {std::nan(""), INFINITY, -INFINITY, 1e39, -1e300, 3.0};
  generator.function = [&wild](double x, double) { return wild[int(x)]; };
  ASSERT_TRUE(generator.updateParams().ok());
  const TeHeightMap map = generator.source()->generate(TeMapRequest::standalone(6, 1, 1, 0).value()).value();
  for (int x = 0; x < 5; ++x)
    EXPECT_TRUE(TeHeightMap::isMissing(map.at(x, 0))) << x;
  EXPECT_EQ(map.at(5, 0), 3.0f);
}
