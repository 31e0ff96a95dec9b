#pragma once

#include "nodes/TeSceneFile.h"
#include "nodes/readScene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/// A scene as the text of a file.
inline std::string written(SoNode* root) {
  const std::string path = testing::TempDir() + "written.iv";
  EXPECT_TRUE(teWriteScene(root, path));
  std::ifstream file(path);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::filesystem::remove(path);
  return text;
}

/// What is read of a scene that was written; it is written alike.
inline TeNodePtr<SoSeparator> readAgain(SoNode* root) {
  const std::string text = written(root);
  SoInput input;
  input.setBuffer(text.data(), text.size());
  const TeNodePtr<SoSeparator> again(SoDB::readAll(&input));
  EXPECT_TRUE(again) << text;
  if (again) {
    EXPECT_EQ(written(again.get()), text);
  }
  return again;
}
