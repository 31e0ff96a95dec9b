#include "nodes/clipmap/TeClipmap.h"

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

TEST(TeClipmap, MayBeRegisteredTwice) {
  const SoType before = SoType::fromName(SbName("TeClipmap"));
  TeClipmap::initClass();
  EXPECT_EQ(SoType::fromName(SbName("TeClipmap")), before);
}

TEST(TeClipmap, LoadsByNameInAProgramThatIsNotLinkedWithIt) {
  const std::string folder = testing::TempDir();
  const std::string scene = folder + "clipmap-by-name.iv";
  const std::string written = folder + "clipmap-by-name-1.iv";
  std::ofstream(scene)
      << "#Inventor V2.1 ascii\nSeparator { TeClipmap { name \"data/ps\" size 257 } Cube {} }\n";
  const std::string program = "LD_LIBRARY_PATH=\"" TERRANE_LIBRARY_FOLDER ":$LD_LIBRARY_PATH\" "
                              "'" TERRANE_READ_BY_NAME "' ";
  EXPECT_EQ(std::system((program + scene + " TeClipmap " + written).c_str()), 0);
  EXPECT_NE(textOf(written).find("TeClipmap"), std::string::npos);
  EXPECT_NE(textOf(written).find("size 257"), std::string::npos);
  for (const std::string& path : {scene, written})
    std::filesystem::remove(path);
}
