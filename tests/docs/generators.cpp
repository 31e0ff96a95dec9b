// Examples of docs/fault-formation.md, docs/midpoint-displacement.md and docs/circles.md.

#include "generators/TeGeneratorRegistry.h"
#include "generators/joining/TeJoiningFaultBlock.h"

#include <gtest/gtest.h>

TEST(DocsGenerators, FaultFormation) {
  //! [faults]
  const TeResult<TeHeightSourcePtr> faults =
      TeGeneratorRegistry::instance().source("faults:faults=80,profile=smooth");
  const TeResult<TeMapRequest> request = TeMapRequest::standalone(300, 200, 1.0, 2007);
  const TeResult<TeHeightMap> map = (*faults)->generate(*request);

  const TeMapSample corner{299, 199};
  float height = 0;
  const TeStatus status = (*faults)->evaluate(*request, &corner, 1, &height);
  //! [faults]
  ASSERT_TRUE(status);
  EXPECT_EQ(height, map->at(299, 199));
}

TEST(DocsGenerators, JoiningFaults) {
  //! [joining]
  TeJoiningFaultParameters parameters;
  parameters.columns = 3;
  parameters.rows = 2;
  TeResult<TeJoiningFaultBlock> block = TeJoiningFaultBlock::create(parameters);
  TeAllowance slice = TeAllowance::seconds(0.001);
  while (!block->step(slice))
    slice = TeAllowance::seconds(0.001);
  const TeHeightMap& west = block->map(0, 0);
  const TeHeightMap& east = block->map(1, 0);
  //! [joining]
  EXPECT_EQ(west.at(65, 20), east.at(1, 20));
}

TEST(DocsGenerators, MidpointAndCircles) {
  //! [midpoint]
  const TeResult<TeHeightSourcePtr> rugged =
      TeGeneratorRegistry::instance().source("midpoint:variant=gaussian,fall=0.6");
  const TeResult<TeHeightSourcePtr> rolling =
      TeGeneratorRegistry::instance().source("circles:circles=500,largest=30");
  const TeStatus refused = (*rugged)->accepts(300, 200);
  //! [midpoint]
  ASSERT_TRUE(rugged);
  ASSERT_TRUE(rolling);
  EXPECT_FALSE(refused);
}
