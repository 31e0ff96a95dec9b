#include "nodes/TeNodes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // testing::TempDir() for this process alone: tests that run at the same time write files of the same names.
  std::string folder = (std::filesystem::temp_directory_path() / "nodes-test-XXXXXX").string();
  if (!mkdtemp(folder.data()))
    return 1;
  ::setenv("TEST_TMPDIR", folder.c_str(), 1);
  TeNodes::init();
  const int status = RUN_ALL_TESTS();
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  return status;
}
