#include "nodes/seamless/TeSeamlessPatches.h"

#include <Inventor/SbName.h>
#include <Inventor/SoType.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

} // namespace

TEST(TeSeamlessPatches, MayBeRegisteredTwice) {
  const SoType before = SoType::fromName(SbName("TeSeamlessPatches"));
  TeSeamlessPatches::initClass();
  EXPECT_EQ(SoType::fromName(SbName("TeSeamlessPatches")), before);
}

TEST(TeSeamlessPatches, LoadsByNameInAProgramThatIsNotLinkedWithIt) {
  const std::string folder = testing::TempDir();
  const std::string scene = folder + "seamless-by-name.iv";
  const std::string first = folder + "seamless-by-name-1.iv";
  const std::string second = folder + "seamless-by-name-2.iv";
  std::ofstream(scene) << "#Inventor V2.1 ascii\nSeparator { TeSeamlessPatches { resolution 1024 } }\n";
  const std::string program = "LD_LIBRARY_PATH=\"" TERRANE_LIBRARY_FOLDER ":$LD_LIBRARY_PATH\" "
                              "'" TERRANE_READ_BY_NAME "' ";
  EXPECT_EQ(std::system((program + scene + " TeSeamlessPatches " + first).c_str()), 0);
  EXPECT_EQ(std::system((program + first + " TeSeamlessPatches " + second).c_str()), 0);
  EXPECT_NE(textOf(first).find("TeSeamlessPatches"), std::string::npos);
  EXPECT_NE(textOf(first).find("resolution 1024"), std::string::npos);
  EXPECT_EQ(textOf(first), textOf(second));
  for (const std::string& path : {scene, first, second})
    std::filesystem::remove(path);
}
