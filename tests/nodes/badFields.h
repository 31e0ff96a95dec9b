#pragma once

#include "nodes/askScene.h"
#include "nodes/coinWarnings.h"
#include "nodes/readScene.h"

#include <gtest/gtest.h>

#include <string>

/// A scene draws nothing, whoever asks, and says so once; its first node of a class knows why.
template <class Node> void expectOneWarningAndNothing(const std::string& text) {
  const CoinWarnings warnings;
  const auto root = readScene(text);
  ASSERT_TRUE(root) << text;
  EXPECT_EQ(triangles(root.get()), 0) << text;
  EXPECT_EQ(triangles(root.get()), 0) << text;
  EXPECT_EQ(emitted(root.get()).size(), 0u) << text;
  EXPECT_TRUE(boxOf(root.get()).isEmpty()) << text;
  EXPECT_EQ(warnings.lines.size(), 1u) << text << ": " << testing::PrintToString(warnings.lines);
  EXPECT_FALSE(firstOf<Node>(root.get())->getError().empty()) << text;
}

/// The same of a node that was good a moment ago; `field`: the name of what is wrong with it.
inline void expectOneWarningAndNothing(SoNode* node, const char* field) {
  const CoinWarnings warnings;
  EXPECT_EQ(triangles(node), 0) << field;
  EXPECT_EQ(triangles(node), 0) << field;
  EXPECT_EQ(warnings.lines.size(), 1u) << field;
}
