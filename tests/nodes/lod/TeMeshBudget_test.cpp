#include "nodes/lod/TeMeshBudget.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(TeMeshBudget, UsesMostOfIt) {
  for (const double power : {0.4, 1.0, 2.5})
    for (const double start : {1.0, 3.0, 1e5})
      for (const std::int64_t budget : {1000, 12345, 900000}) {
        double last = 0;
        const auto count = [&](double coarsening) {
          last = coarsening;
          return std::int64_t(1e6 / std::pow(coarsening, power)) + 4;
        };
        const double found = TeMeshBudget::search(budget, start, count);
        EXPECT_EQ(found, last); // the mesh is there
        EXPECT_LE(count(found), budget);
        EXPECT_GE(double(count(found)), TeMeshBudget::kUsed * double(budget));
      }
}

TEST(TeMeshBudget, WantsNoMoreThanIsNeeded) {
  int calls = 0;
  const auto few = [&](double) { return calls++, std::int64_t(10); };
  EXPECT_EQ(TeMeshBudget::search(1000, 1, few), 1);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(TeMeshBudget::search(1000, 500, few), 1); // from a much coarser one
}

TEST(TeMeshBudget, StopsAtStepsAndAtTheCoarsest) {
  const auto steps = [](double coarsening) { return std::int64_t(coarsening < 7 ? 5000 : 100); };
  const double found = TeMeshBudget::search(1000, 1, steps);
  EXPECT_GE(found, 7);
  EXPECT_LT(found, 20);
  const auto many = [](double) { return std::int64_t(4); };
  EXPECT_GT(TeMeshBudget::search(1, 1, many), 1e11);
}
