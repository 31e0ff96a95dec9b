#include "nodes/clipmap/SoTeClipmap.h"

#include "nodes/TeNodePtr.h"
#include "nodes/clipmap/testPyramid.h"
#include "nodes/coinWarnings.h"
#include "nodes/fileFormat.h"
#include "nodes/logLines.h"
#include "nodes/writtenScene.h"

#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <fstream>

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

TeNodePtr<SoTeClipmap> makeNode(const std::string& name) {
  TeNodePtr<SoTeClipmap> node(new SoTeClipmap);
  node->name = name.c_str();
  return node;
}

} // namespace

TEST(SoTeClipmap, HeaderTellsFieldsAndDefaults) {
  EXPECT_EQ(fieldsOf(TeNodePtr<SoTeClipmap>(new SoTeClipmap).get()),
            fileFormat("nodes/clipmap/SoTeClipmap.h"));
}

TEST(SoTeClipmap, FieldsSurviveWritingAndReading) {
  const auto root = readScene("TeClipmap { name \"a b/ps\" size 257 kind COLOR format HALF maxLevel 12 "
                              "uploadBudget 5000 cacheBytes 70000 }");
  ASSERT_TRUE(root);
  const auto again = readAgain(root.get());
  ASSERT_TRUE(again);
  ASSERT_TRUE(again->getChild(0)->isOfType(SoTeClipmap::getClassTypeId()));
  const auto* node = static_cast<const SoTeClipmap*>(again->getChild(0));
  EXPECT_EQ(node->name.getValue(), "a b/ps");
  EXPECT_EQ(node->size.getValue(), 257);
  EXPECT_EQ(node->kind.getValue(), SoTeClipmap::COLOR);
  EXPECT_EQ(node->format.getValue(), SoTeClipmap::HALF);
  EXPECT_EQ(node->maxLevel.getValue(), 12);
  EXPECT_EQ(node->uploadBudget.getValue(), 5000);
  EXPECT_EQ(node->cacheBytes.getValue(), 70000);
}

TEST(SoTeClipmap, FilesLieBesideTheScenesFile) {
  const TestPyramid pyramid(6);
  const std::string scene = pyramid.folder() + "/scene.iv";
  std::ofstream(scene) << "#Inventor V2.1 ascii\nTeClipmap { name \"p\" size 17 }\n";
  SoInput input;
  ASSERT_TRUE(input.openFile(scene.c_str()));
  const TeNodePtr<SoSeparator> root(SoDB::readAll(&input));
  ASSERT_TRUE(root && root->getNumChildren() == 1);
  auto* node = static_cast<SoTeClipmap*>(root->getChild(0));
  EXPECT_EQ(node->getError(), "");
  EXPECT_EQ(node->getPath(), pyramid.name());
  ASSERT_TRUE(node->getTiles());
  EXPECT_EQ(node->getTiles()->reader().topLevel(), 6);
  const TeNodePtr<SoTeClipmap> copy(static_cast<SoTeClipmap*>(node->copy()));
  EXPECT_EQ(copy->getPath(), pyramid.name());
  EXPECT_TRUE(copy->getTiles());
  EXPECT_NE(copy->getTiles(), node->getTiles());
}

TEST(SoTeClipmap, EveryContextGetsWindowsOfItsOwnOverTheSameTiles) {
  const TestPyramid pyramid(6);
  const auto node = makeNode(pyramid.name());
  node->size = 17;
  const auto first = node->makeWindows();
  const auto second = node->makeWindows(5);
  ASSERT_TRUE(first && second);
  EXPECT_EQ((*first)->baseLevel(), 4);
  EXPECT_EQ((*first)->topLevel(), 6);
  EXPECT_EQ((*second)->topLevel(), 5);
  const std::int64_t misses = node->getTiles()->statistics().misses;
  (*first)->update({20, 20}, 6, 0);
  EXPECT_GT(node->getTiles()->statistics().misses, misses);
  EXPECT_TRUE((*first)->isSettled());
  EXPECT_FALSE((*second)->isSettled());
}

TEST(SoTeClipmap, WhatCannotBeOpenedGivesOneWarningAndIsTriedAgainAfterAChange) {
  const TestPyramid pyramid(6);
  const CoinWarnings warnings;
  const auto node = makeNode(pyramid.folder() + "/nothing");
  EXPECT_FALSE(node->getTiles());
  EXPECT_FALSE(node->getTiles());
  EXPECT_FALSE(node->makeWindows());
  EXPECT_THAT(node->getError(), HasSubstr("nothing_0.raw"));
  EXPECT_THAT(warnings.lines, ElementsAre(AllOf(HasSubstr("TeClipmap"), HasSubstr("nothing_0.raw"))));
  node->name = pyramid.name().c_str();
  EXPECT_TRUE(node->getTiles());
  EXPECT_EQ(node->getError(), "");
  EXPECT_EQ(warnings.lines.size(), 1u);
}

TEST(SoTeClipmap, AbsurdFieldsAreErrors) {
  const TestPyramid pyramid(4);
  const CoinWarnings warnings;
  for (const int size : {INT_MIN, -513, 0, 4, 8194, INT_MAX}) {
    const auto node = makeNode(pyramid.name());
    node->size = size;
    EXPECT_FALSE(node->makeWindows());
    EXPECT_THAT(node->getError(), HasSubstr(std::to_string(size)));
  }
  for (const int level : {INT_MIN, -2, 23, INT_MAX}) {
    const auto node = makeNode(pyramid.name());
    node->maxLevel = level;
    EXPECT_THAT(node->getError(), HasSubstr(std::to_string(level)));
  }
  for (const int kind : {SoTeClipmap::HEIGHT, SoTeClipmap::COLOR}) {
    const auto node = makeNode("");
    node->kind = kind;
    EXPECT_THAT(node->getError(), HasSubstr("empty"));
  }
  const auto node = makeNode(pyramid.name());
  node->cacheBytes = INT_MIN;
  node->uploadBudget = INT_MIN;
  EXPECT_TRUE(node->makeWindows());
  EXPECT_EQ(node->getUploadBudget(), 0u);
}

TEST(SoTeClipmap, ALevelThatIsMissingIsReportedInTheLog) {
  const TestPyramid pyramid(6);
  std::filesystem::remove(pyramid.file(5));
  const LogLines log;
  const CoinWarnings warnings;
  const auto node = makeNode(pyramid.name());
  node->size = 17;
  ASSERT_TRUE(node->getTiles());
  EXPECT_EQ(node->getTiles()->reader().topLevel(), 4);
  EXPECT_TRUE(warnings.lines.empty());
  EXPECT_THAT(log.lines, ElementsAre(HasSubstr(pyramid.file(5))));
}

TEST(SoTeClipmap, ColoursOfThreeAndFourBytes) {
  for (const int bytes : {3, 4}) {
    const TestPyramid pyramid(5, bytes);
    const auto node = makeNode(pyramid.name());
    node->kind = SoTeClipmap::COLOR;
    ASSERT_TRUE(node->getTiles()) << node->getError();
    EXPECT_EQ(node->getTiles()->bytesPerSample(), bytes);
    EXPECT_EQ(node->getFormat(), TeClipFormat::Colour);
  }
  const TestPyramid heights(5);
  const CoinWarnings warnings;
  const auto node = makeNode(heights.name());
  node->kind = SoTeClipmap::COLOR;
  EXPECT_FALSE(node->getTiles());
}

TEST(SoTeClipmap, BudgetAndFormatLeaveTheFilesOpen) {
  const TestPyramid pyramid(5);
  const auto node = makeNode(pyramid.name());
  const auto tiles = node->getTiles();
  ASSERT_TRUE(tiles);
  EXPECT_EQ(node->getFormat(), TeClipFormat::Short);
  node->uploadBudget = 100;
  node->format = SoTeClipmap::HALF;
  EXPECT_EQ(node->getTiles(), tiles);
  EXPECT_EQ(node->getFormat(), TeClipFormat::Half);
  EXPECT_EQ(node->getUploadBudget(), 100u);
  node->format = SoTeClipmap::FLOAT;
  EXPECT_EQ(node->getFormat(), TeClipFormat::Float);
  node->size = 9;
  EXPECT_NE(node->getTiles(), tiles);
}

TEST(SoTeClipmap, InASceneItDoesNothingAndOpensNothing) {
  const CoinWarnings warnings;
  const auto root = readScene("TeClipmap { name \"nowhere/nothing\" }");
  ASSERT_TRUE(root);
  const SbViewportRegion viewport(100, 100);
  SoGetBoundingBoxAction bounds(viewport);
  bounds.apply(root.get());
  EXPECT_TRUE(bounds.getBoundingBox().isEmpty());
  SoGetPrimitiveCountAction count;
  count.apply(root.get());
  EXPECT_EQ(count.getTriangleCount(), 0);
  SoRayPickAction pick(viewport);
  pick.setRay(SbVec3f(0, 0, 5), SbVec3f(0, 0, -1));
  pick.apply(root.get());
  EXPECT_EQ(pick.getPickedPoint(), nullptr);
  EXPECT_TRUE(warnings.lines.empty());
}
