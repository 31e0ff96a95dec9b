#include "nodes/context/TeGlLoader.h"

#include "nodes/logLines.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

int seven() { return 7; }

} // namespace

TEST(TeGlLoader, GivesFunctionsByNameAndTellsOfTheFirstThatIsMissing) {
  TeGlLoader gl([](const std::string& name) {
    return name.find("No") == 0 ? nullptr : reinterpret_cast<void*>(&seven);
  });
  int (*function)() = nullptr;
  gl.need("First", function);
  EXPECT_EQ(function(), 7);
  EXPECT_FALSE(gl.find("NotNeeded", function));
  EXPECT_EQ(function, nullptr);
  EXPECT_TRUE(gl.find("Second", function));
  EXPECT_EQ(gl.missing(), nullptr);
  EXPECT_TRUE(gl.isComplete("nothing is drawn"));
  for (const char* name : {"No1", "Third", "No2"})
    gl.need(name, function);
  EXPECT_STREQ(gl.missing(), "No1");
  LogLines log;
  EXPECT_FALSE(gl.isComplete("nothing is drawn"));
  EXPECT_EQ(log.lines, std::vector<std::string>{"nothing is drawn: OpenGL lacks No1"});
}
