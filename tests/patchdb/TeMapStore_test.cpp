#include "patchdb/TeMapStore.h"

#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <thread>

namespace {

std::shared_ptr<const TeSourceChooser> sourceNumber(std::uint64_t salt) {
  return std::make_shared<TeSingleSource>(std::make_shared<TeHashSource>(salt));
}

TeHeightMap map(int side) { return *TeHeightMap::create(side, side); }

} // namespace

TEST(TeMapStore, AKeyKeepsTheSourceOfItsTime) {
  TeMapStore store(sourceNumber(1));
  EXPECT_EQ(store.source({5, 5}), nullptr);
  ASSERT_TRUE(store.begin({5, 5}));
  store.setChooser(sourceNumber(2));
  ASSERT_TRUE(store.begin({6, 5}));
  store.setChooser(sourceNumber(3)); // nothing is begun with it
  store.setChooser(sourceNumber(4));
  ASSERT_TRUE(store.begin({7, 5}));
  const std::uint64_t salts[] = {1, 2, 4};
  for (int i = 0; i < 3; ++i) {
    const TeHeightSourcePtr expected = std::make_shared<TeHashSource>(salts[i]);
    EXPECT_EQ(store.source({5 + i, 5})->fingerprint(), expected->fingerprint());
    EXPECT_EQ((*store.begin({5 + i, 5}))->fingerprint(), expected->fingerprint());
  }
  EXPECT_EQ(store.begunMaps(), 3u);
}

TEST(TeMapStore, CountsMapsAsTheyComeAndGo) {
  TeMapStore store(sourceNumber(1));
  std::vector<TeSourceMapPtr> maps;
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(store.begin({i, 0}));
    maps.push_back(store.add({i, 0}, map(9)));
  }
  EXPECT_EQ(store.add({3, 0}, map(9)), maps[3]); // the first to finish stores it
  EXPECT_EQ(store.find({3, 0}), maps[3]);
  EXPECT_EQ(store.residentMaps(), 10u);
  EXPECT_EQ(store.residentBytes(), 10u * 81 * 4);
  maps.resize(4);
  EXPECT_EQ(store.residentMaps(), 4u);
  EXPECT_EQ(store.find({7, 0}), nullptr);
  EXPECT_NE(store.source({7, 0}), nullptr);
  maps.clear();
  EXPECT_EQ(store.residentMaps(), 0u);
  EXPECT_EQ(store.residentBytes(), 0u);
}

TEST(TeMapStore, MapsMayOutliveItAndGoInOtherThreads) {
  auto store = std::make_unique<TeMapStore>(sourceNumber(1));
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(store->begin({i, 0}));
    threads.emplace_back([kept = store->add({i, 0}, map(33))]() mutable { kept.reset(); });
  }
  TeSourceMapPtr kept = store->add({0, 0}, map(33));
  store.reset();
  EXPECT_EQ(kept->heights.width(), 33);
  kept.reset();
  for (std::thread& thread : threads)
    thread.join();
}

TEST(TeMapStore, WhatItRemembersIsSmall) {
  TeMapStore store(sourceNumber(1));
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      ASSERT_TRUE(store.begin({x, y}));
  EXPECT_EQ(store.begunMaps(), 40000u);
  EXPECT_LT(store.recordBytes(), 40000u * 2);
}
