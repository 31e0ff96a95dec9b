#include "engine/terrain/TePatchCandidates.h"

#include <gtest/gtest.h>

namespace {

TeUrgency urgency(double distance) { return {0, distance, {std::int64_t(distance), 0, 0}}; }

TEST(TePatchCandidates, TheMostUrgentComeFirstAndNoMoreThanTheQueueHasRoomFor) {
  TePatchCandidates candidates;
  for (int i = 0; i < 100; ++i)
    candidates.add(TeJobKind::Ahead, urgency((i * 37) % 100));
  candidates.sort();
  const int room = int(TePatchCandidates::kQueued[std::size_t(TeJobKind::Ahead)]);
  TeUrgency next;
  for (int i = 0; i < room; ++i) {
    ASSERT_TRUE(candidates.take(TeJobKind::Ahead, next));
    EXPECT_EQ(next.distance, i);
    candidates.queued(TeJobKind::Ahead);
  }
  EXPECT_FALSE(candidates.take(TeJobKind::Ahead, next));
  EXPECT_FALSE(candidates.take(TeJobKind::Block, next));
  EXPECT_FALSE(candidates.empty()) << "there were more";
}

TEST(TePatchCandidates, OthersAreLookedForWhenTheQueueIsHalfEmpty) {
  TePatchCandidates candidates;
  const int room = int(TePatchCandidates::kQueued[std::size_t(TeJobKind::Block)]);
  for (int i = 0; i < room + 1; ++i)
    candidates.add(TeJobKind::Block, urgency(i));
  candidates.sort();
  TeUrgency next;
  while (candidates.take(TeJobKind::Block, next))
    candidates.queued(TeJobKind::Block);
  EXPECT_FALSE(candidates.outdated());
  for (int i = 0; i <= room / 2; ++i)
    candidates.unqueued(TeJobKind::Block);
  EXPECT_TRUE(candidates.outdated());
  candidates.clear();
  candidates.add(TeJobKind::Block, urgency(room));
  candidates.sort();
  EXPECT_FALSE(candidates.outdated());
  EXPECT_TRUE(candidates.take(TeJobKind::Block, next));
  EXPECT_EQ(next.distance, room);
  EXPECT_TRUE(candidates.empty());
}

} // namespace
