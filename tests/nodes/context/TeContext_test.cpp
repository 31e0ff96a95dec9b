#include "nodes/context/TeContext.h"

#include <gtest/gtest.h>

TEST(TeContextKind, NamesGoBothWays) {
  for (TeContextKind kind : {TeContextKind::Window, TeContextKind::Egl, TeContextKind::OsMesa}) {
    const TeResult<TeContextKind> back = teContextKind(teContextName(kind));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, kind);
  }
  for (const char* name : {"", "EGL", "glx", "osmesa "}) {
    const TeResult<TeContextKind> kind = teContextKind(name);
    ASSERT_FALSE(kind);
    EXPECT_NE(kind.error().message.find("window, egl, osmesa"), std::string::npos);
  }
}

// This program was not started by a launcher, so Coin is bound to another OpenGL: pictures would be wrong and
// nothing would say so.
TEST(TeContext, OsMesaIsRefusedWhereItIsNotFirst) {
  const auto context = TeContext::create(TeContextKind::OsMesa, 16, 16);
  ASSERT_FALSE(context);
  EXPECT_NE(context.error().message.find("launcher"), std::string::npos) << context.error().message;
}
