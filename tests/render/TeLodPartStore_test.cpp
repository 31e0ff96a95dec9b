#include "nodes/lod/drawing/TeLodPartStore.h"

#include "render/TeRenderTest.h"

namespace {

constexpr std::size_t kVertices = 10;
constexpr std::size_t kLimit = 40000; ///< some 50 parts of 720 bytes, as most they might take without indices

TeLodArrays part() {
  TeLodArrays arrays;
  arrays.vertices.resize(kVertices);
  for (std::uint16_t i = 0; i < 30; i++)
    arrays.shortIndices.push_back(std::uint16_t(i % kVertices));
  return arrays;
}

class TeLodPartStoreTest : public TeRenderTest {
protected:
  void SetUp() override {
    TeRenderTest::SetUp();
    ASSERT_TRUE(context().makeCurrent());
    ASSERT_TRUE(m_gl.load(context().id()));
    m_sender = std::make_unique<TeLodSender>(m_gl);
    m_store = std::make_unique<TeLodPartStore>(*m_sender, kLimit);
    m_sender->begin(TeLodSubmission::VboStatic, false);
  }
  void TearDown() override {
    m_store->clear();
    m_sender->end();
  }
  bool add(std::uint64_t key) {
    TeLodArrays arrays = part();
    return m_store->add(key, arrays) != nullptr;
  }

  TeLodGl m_gl;
  std::unique_ptr<TeLodSender> m_sender;
  std::unique_ptr<TeLodPartStore> m_store;
};

} // namespace

TEST_F(TeLodPartStoreTest, FindsWhatWasAdded) {
  EXPECT_EQ(m_store->find(7), nullptr);
  ASSERT_TRUE(add(7));
  const TeLodSender::Kept* kept = m_store->find(7);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->triangles, 10);
  EXPECT_EQ(kept->bytes, kVertices * 24 + 60);
  EXPECT_EQ(m_store->bytes(), kept->bytes);
  EXPECT_EQ(m_store->size(), 1u);
}

TEST_F(TeLodPartStoreTest, MemoryIsBoundedAndTheOldestGo) {
  const std::int64_t live = TeLodSender::live();
  for (std::uint64_t frame = 0; frame < 500; frame++) {
    m_store->beginFrame();
    EXPECT_EQ(m_store->find(0) != nullptr, frame > 0) << frame; // drawn in every frame
    EXPECT_TRUE(add(frame));
    EXPECT_LE(m_store->bytes(), kLimit);
  }
  EXPECT_TRUE(m_store->find(499));
  EXPECT_TRUE(m_store->find(480));
  EXPECT_FALSE(m_store->find(1));
  EXPECT_FALSE(m_store->find(200));
  EXPECT_EQ(TeLodSender::live() - live, 2 * std::int64_t(m_store->size()));
  m_store->clear();
  EXPECT_EQ(TeLodSender::live(), live);
  EXPECT_EQ(m_store->bytes(), 0u);
}

TEST_F(TeLodPartStoreTest, WhatAFrameDrawsStays) {
  m_store->beginFrame();
  std::uint64_t added = 0;
  while (add(added))
    added++;
  EXPECT_GT(added, 30u);
  for (std::uint64_t key = 0; key < added; key++)
    EXPECT_TRUE(m_store->find(key));
  // The next frame may take their place.
  m_store->beginFrame();
  EXPECT_TRUE(add(added));
}
