#include "nodes/TeSceneFile.h"

#include "generators/base/TeRandom.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <vector>

// From 1000 to 1024, and from 0.1 to 0.125, eight digits are not enough to tell floats apart.
TEST(TeSceneFile, EveryFloatReadsBackTheSame) {
  SoDB::init();
  TeRandom random(7, 0, {});
  std::vector<SbVec3f> points;
  for (int i = 0; i < 5000; ++i)
    points.push_back(SbVec3f(float(1000 + 24 * random.uniform()), float(0.1 + 0.025 * random.uniform()),
                             float(2e6 * random.uniform() - 1e6)));
  points.push_back(SbVec3f(3.4028235e38f, -1.17549435e-38f, 0.0f));
  auto* coordinates = new SoCoordinate3;
  coordinates->point.setValues(0, int(points.size()), points.data());
  TeNodePtr<SoSeparator> scene(new SoSeparator);
  scene->addChild(coordinates);
  const std::string path = testing::TempDir() + "floats.iv";
  ASSERT_TRUE(teWriteScene(scene.get(), path));

  SoInput input;
  ASSERT_TRUE(input.openFile(path.c_str()));
  const TeNodePtr<SoSeparator> read(SoDB::readAll(&input));
  input.closeFile();
  std::filesystem::remove(path);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->getNumChildren(), 1);
  const SoMFVec3f& again = static_cast<SoCoordinate3*>(read->getChild(0))->point;
  ASSERT_EQ(again.getNum(), int(points.size()));
  int different = 0;
  for (int i = 0; i < again.getNum(); ++i)
    different += std::memcmp(&again[i], &points[std::size_t(i)], sizeof(SbVec3f)) != 0 ? 1 : 0;
  EXPECT_EQ(different, 0);
}
