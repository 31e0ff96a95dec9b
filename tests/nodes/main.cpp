#include "nodes/TeNodes.h"

#include <gtest/gtest.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  TeNodes::init();
  return RUN_ALL_TESTS();
}
