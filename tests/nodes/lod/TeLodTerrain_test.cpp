#include "nodes/lod/TeLodTerrain.h"

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

TEST(TeLodTerrain, MayBeRegisteredTwice) {
  const SoType before = SoType::fromName(SbName("TeLodTerrain"));
  TeLodTerrain::initClass();
  EXPECT_EQ(SoType::fromName(SbName("TeLodTerrain")), before);
}

TEST(TeLodTerrain, LoadsByNameInAProgramThatIsNotLinkedWithIt) {
  const std::string folder = testing::TempDir();
  const std::string scene = folder + "lod-by-name.iv";
  const std::string first = folder + "lod-by-name-1.iv";
  const std::string second = folder + "lod-by-name-2.iv";
  const std::string raw = folder + "lod-by-name.raw";
  std::ofstream(raw, std::ios::binary) << std::string(2 * 33 * 33, '\1');
  std::ofstream(scene) << "#Inventor V2.1 ascii\nSeparator { TeLodTerrain { method \"brute\" heightFile "
                          "\"lod-by-name.raw\" } }\n";
  const std::string program = "LD_LIBRARY_PATH=\"" TERRANE_LIBRARY_FOLDER ":$LD_LIBRARY_PATH\" "
                              "'" TERRANE_READ_BY_NAME "' ";
  EXPECT_EQ(std::system((program + scene + " TeLodTerrain " + first).c_str()), 0);
  EXPECT_EQ(std::system((program + first + " TeLodTerrain " + second).c_str()), 0);
  EXPECT_NE(textOf(first).find("TeLodTerrain"), std::string::npos);
  EXPECT_NE(textOf(first).find("method \"brute\""), std::string::npos);
  EXPECT_EQ(textOf(first), textOf(second));
  for (const std::string& path : {scene, first, second, raw})
    std::filesystem::remove(path);
}
