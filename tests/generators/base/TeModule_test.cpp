#include "generators/base/TeModule.h"

#include <gtest/gtest.h>

TEST(TeModule, AMissingModuleIsAnErrorThatNamesIt) {
  for (const char* name : {"TerraneNoSuchModule", "", "../TerraneGenerators"}) {
    const auto symbol = teModuleSymbol(name, "teNothing");
    ASSERT_FALSE(symbol.ok());
    EXPECT_NE(symbol.error().message.find(name), std::string::npos) << symbol.error().message;
    EXPECT_EQ(symbol.error().message.find('\n'), std::string::npos);
  }
}
