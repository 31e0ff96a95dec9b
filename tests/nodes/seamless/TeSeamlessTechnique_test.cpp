#include "nodes/seamless/TeSeamlessTechnique.h"

#include <gtest/gtest.h>

#include <set>

TEST(TeSeamlessTechnique, TheDocuments18CombinationsComeFirstEachByItsOwnName) {
  const std::vector<TeSeamlessTechnique> all = TeSeamlessTechnique::all();
  ASSERT_EQ(all.size(), 24u);
  std::set<std::string> document;
  for (const char* heights : {"Flat", "Heightmap", "Clipmaps"})
    for (const char* colours : {"Color", "Texture", "Detailmaps"})
      for (const char* way : {"Classic", "Instanced"})
        document.insert(std::string(heights) + colours + way);
  std::set<std::string> first;
  std::set<std::string> names;
  for (std::size_t i = 0; i < all.size(); i++) {
    names.insert(all[i].name());
    if (i < 18)
      first.insert(all[i].name());
  }
  EXPECT_EQ(first, document);
  EXPECT_EQ(names.size(), all.size());
}

TEST(TeSeamlessTechnique, ANameGivesItsTechniqueBack) {
  for (const TeSeamlessTechnique& technique : TeSeamlessTechnique::all()) {
    const TeResult<TeSeamlessTechnique> named = TeSeamlessTechnique::named(technique.name());
    ASSERT_TRUE(named) << named.error().message;
    EXPECT_TRUE(*named == technique);
  }
  for (const char* wrong : {"", "flatcolorclassic", "FlatColor", "ClipmapsTextureInstancedX"}) {
    const TeResult<TeSeamlessTechnique> named = TeSeamlessTechnique::named(wrong);
    ASSERT_FALSE(named) << wrong;
    EXPECT_NE(named.error().message.find(wrong), std::string::npos);
    EXPECT_NE(named.error().message.find("ClipmapsTextureInstanced"), std::string::npos);
  }
}
