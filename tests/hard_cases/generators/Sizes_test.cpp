#include "tests/generators/TeEveryGenerator.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

namespace {

/// Makes a map of that size by the public adapter, or gives the error.
TeResult<TeHeightMap> make(TeGenerator& generator, int columns, int rows) {
  TeMapRequest request;
  request.columns = columns;
  request.rows = rows;
  if (TeStatus ok = generator.start(request); !ok)
    return ok.error();
  if (TeStatus ok = generator.generate(); !ok)
    return ok.error();
  return generator.takeMap();
}

bool isOneClearLine(const std::string& message) {
  return message.size() > 10 && message.size() < 400 && message.find('\n') == std::string::npos;
}

} // namespace

TEST(HardCase, Sizes) {
  int accepted = 0;
  int refused = 0;
  for (const TeChainUnderTest& chain : teEveryGenerator()) {
    const auto generator = TeGeneratorRegistry::instance().chain(chain.generator, chain.filters).value();
    for (int columns = 0; columns <= 70; ++columns)
      for (int rows : {columns, 1, 7, 70 - columns}) {
        const auto map = make(*generator, columns, rows);
        if (map.ok()) {
          ASSERT_EQ(map->width(), columns) << chain.name();
          ASSERT_EQ(map->height(), rows) << chain.name();
          ++accepted;
        } else {
          ASSERT_TRUE(isOneClearLine(map.error().message)) << map.error().message;
          ++refused;
        }
        ASSERT_FALSE(map.ok() && (columns == 0 || rows == 0)) << chain.name();
      }
    // Nothing of this size may be begun, let alone allocated.
    const int most = std::numeric_limits<int>::max();
    for (const auto& [columns, rows] :
         {std::pair(0, 0), std::pair(-1, 5), std::pair(5, -1), std::pair(most, most), std::pair(most, 1),
          std::pair(1 << 15, 1 << 14)}) {
      const auto map = make(*generator, columns, rows);
      ASSERT_FALSE(map.ok()) << chain.name() << " " << columns << "x" << rows;
      EXPECT_TRUE(isOneClearLine(map.error().message)) << map.error().message;
      ++refused;
      TeMapRequest request;
      request.columns = columns;
      request.rows = rows;
      const auto direct = generator->source()->generate(request);
      ASSERT_FALSE(direct.ok()) << chain.name() << " " << columns << "x" << rows;
      EXPECT_TRUE(isOneClearLine(direct.error().message)) << direct.error().message;
    }
    // Long and thin.
    for (const auto& [columns, rows] : {std::pair(10001, 1), std::pair(1, 10001), std::pair(3000, 3)}) {
      const auto map = make(*generator, columns, rows);
      if (map.ok()) {
        EXPECT_EQ(map->width(), columns);
        EXPECT_EQ(map->height(), rows);
      } else {
        EXPECT_TRUE(isOneClearLine(map.error().message)) << map.error().message;
      }
      (map.ok() ? accepted : refused) += 1;
    }
  }
  std::printf("%d sizes accepted, %d refused with one clear line\n", accepted, refused);
}
