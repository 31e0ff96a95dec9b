#include "engine/paths/TePath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

namespace {

TePathPoint at(double x, double y, double z) {
  TePathPoint point;
  point.place = {x, y, z};
  return point;
}

std::string errorOf(const std::string& text) {
  const TeResult<TePath> path = TePath::parse(text, "p.txt");
  return path ? "" : path.error().message;
}

TEST(TePath, IsReadFromText) {
  const auto path = TePath::parse("# a flight\n"
                                  "\n"
                                  "0 0 120 40\r\n"
                                  "\t-3e2  400 120 # keeps its speed\n"
                                  "jump 1e6 0 +60\n"
                                  "1000000 80 +60 55.5",
                                  "p.txt");
  ASSERT_TRUE(path) << path.error().message;
  ASSERT_EQ(path->points().size(), 4u);
  EXPECT_FALSE(path->repeats());
  EXPECT_EQ(path->points()[1].place, glm::dvec3(-300, 400, 120));
  EXPECT_EQ(path->points()[1].speed, 40);
  EXPECT_FALSE(path->points()[1].aboveGround);
  EXPECT_TRUE(path->points()[2].jump);
  EXPECT_TRUE(path->points()[3].aboveGround);
  EXPECT_EQ(path->points()[3].place.z, 60);
  EXPECT_EQ(path->points()[3].speed, 55.5);
  EXPECT_EQ(path->legLength(1), 500);
  EXPECT_EQ(path->legLength(2), 0);
  EXPECT_EQ(path->length(), 580);
}

TEST(TePath, RepeatsFromItsLastPoint) {
  const auto path = TePath::parse("0 0 5\n3 4 5\nrepeat\n", "p.txt");
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_TRUE(path->repeats());
  EXPECT_EQ(path->roundShift(), glm::dvec3(3, 4, 0));
}

TEST(TePath, ErrorsNameFileAndLine) {
  EXPECT_EQ(errorOf("0 0 1\n0 9 x\n"), "p.txt:2: \"x\" is no coordinate");
  EXPECT_EQ(errorOf("0 0 nan\n"), "p.txt:1: \"nan\" is no coordinate");
  EXPECT_EQ(errorOf("0 0 1 -5\n"), "p.txt:1: the speed must lie within 0 and 1e+07 m/s");
  EXPECT_EQ(errorOf("0 0 1 0\n"), "p.txt:1: \"0\" is no speed");
  EXPECT_EQ(errorOf("0 0 1\n\n0 0 1\n"), "p.txt:3: the point is where the one before is");
  for (const char* text :
       {"1 2\n", "1 2 3 4 5\n", "jump\n", "repeat 5\n", "0 0 ++5\n", "0 0 +\n", "0 0 1e999\n", "0 5e15 1\n",
        "jump 0 0 1\n", "0 0 1\n0 9 +1\n", "0 0 1\n0 9 1\nrepeat\n0 10 1\n"})
    EXPECT_EQ(errorOf(text).rfind("p.txt:", 0), 0u) << text << ": " << errorOf(text);
}

TEST(TePath, APathWithoutALegIsRefused) {
  for (const char* text : {"", "# nothing\n", "0 0 1\n", "0 0 1\njump 5 0 1\n", "repeat\n"})
    EXPECT_EQ(errorOf(text).rfind("p.txt: path", 0), 0u) << text << ": " << errorOf(text);
}

TEST(TePath, NumbersThatAreNoneAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(TePath::create({at(0, 0, 0), at(0, nan, 0)}));
  TePathPoint fast = at(0, 0, 0);
  fast.speed = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(TePath::create({fast, at(0, 1, 0)}));
}

TEST(TePath, SizesAreBounded) {
  std::string text = "0 0 1\n";
  for (std::size_t i = 0; i <= TePath::kMaxPoints; ++i)
    text += i % 2 ? "0 0 1\n" : "1 0 1\n";
  EXPECT_NE(errorOf(text).find("more than 100000 points"), std::string::npos);

  const std::string file = testing::TempDir() + "terrane-long-path.txt";
  std::ofstream(file) << std::string(TePath::kMaxBytes + 1, ' ');
  const TeResult<TePath> large = TePath::read(file);
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().message.find("too large"), std::string::npos);
  std::remove(file.c_str());
}

TEST(TePath, FilesThatCannotBeRead) {
  for (const char* file : {"/no/such/path.txt", "/tmp"}) {
    const TeResult<TePath> path = TePath::read(file);
    ASSERT_FALSE(path) << file;
    EXPECT_EQ(path.error().message.rfind(std::string(file) + ": cannot be read: ", 0), 0u)
        << path.error().message;
  }
}

} // namespace
