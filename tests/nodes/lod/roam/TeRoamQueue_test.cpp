#include "nodes/lod/roam/TeRoamQueue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace {

struct Item {
  std::int32_t node;
  std::uint32_t number;
  float priority;
};

std::vector<Item> someItems(int count, std::mt19937& random) {
  std::vector<Item> items;
  for (int i = 0; i < count; i++)
    items.push_back({i, std::uint32_t(i * 7919 % count), float(random() % 20)});
  return items;
}

std::vector<std::uint32_t> drained(TeRoamQueue& queue, const std::vector<Item>& items) {
  std::vector<std::uint32_t> order;
  while (!queue.empty()) {
    order.push_back(items[std::size_t(queue.top())].number);
    queue.remove(queue.top());
    EXPECT_TRUE(queue.isConsistent());
  }
  return order;
}

std::vector<std::uint32_t> sorted(std::vector<Item> items) {
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    return a.priority != b.priority ? a.priority > b.priority : a.number < b.number;
  });
  std::vector<std::uint32_t> order;
  for (const Item& item : items)
    order.push_back(item.number);
  return order;
}

} // namespace

TEST(TeRoamQueue, givesByPriorityThenNumberAndInReverse) {
  std::mt19937 random(1);
  const std::vector<Item> items = someItems(501, random);
  std::vector<std::uint32_t> wanted = sorted(items);
  TeRoamQueue most(TeRoamQueue::Order::MostImportantFirst), least(TeRoamQueue::Order::LeastImportantFirst);
  for (const Item& item : items)
    for (TeRoamQueue* queue : {&most, &least})
      queue->insert(item.node, item.number, item.priority);
  EXPECT_EQ(most.topPriority(), 19);
  EXPECT_EQ(least.topPriority(), 0);
  EXPECT_EQ(drained(most, items), wanted);
  std::reverse(wanted.begin(), wanted.end());
  EXPECT_EQ(drained(least, items), wanted);
}

TEST(TeRoamQueue, refreshIsTheSameAsInsertingAnew) {
  std::mt19937 random(2);
  for (const auto order : {TeRoamQueue::Order::MostImportantFirst, TeRoamQueue::Order::LeastImportantFirst}) {
    std::vector<Item> items = someItems(200, random);
    TeRoamQueue kept(order), anew(order);
    for (const Item& item : items)
      kept.insert(item.node, item.number, item.priority);
    std::vector<float> priorities;
    for (Item& item : items) {
      item.priority = random() % 5 ? item.priority : float(random() % 20);
      priorities.push_back(item.priority);
      anew.insert(item.node, item.number, item.priority);
    }
    kept.refresh(priorities.data());
    EXPECT_TRUE(kept.isConsistent());
    EXPECT_EQ(drained(kept, items), drained(anew, items));
  }
}

TEST(TeRoamQueue, knowsWhatItHoldsAfterAnyChanges) {
  std::mt19937 random(3);
  TeRoamQueue queue(TeRoamQueue::Order::MostImportantFirst);
  std::vector<char> isIn(300, 0);
  for (int step = 0; step < 5000; step++) {
    const auto node = std::int32_t(random() % 300);
    char& in = isIn[std::size_t(node)];
    if (in)
      queue.remove(node);
    else
      queue.insert(node, std::uint32_t(node), float(random() % 50));
    in = !in;
    ASSERT_EQ(queue.contains(node), bool(in));
  }
  EXPECT_TRUE(queue.isConsistent());
  EXPECT_EQ(queue.size(), std::size_t(std::count(isIn.begin(), isIn.end(), 1)));
  queue.clear();
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.isConsistent());
  EXPECT_FALSE(queue.contains(5));
}

TEST(TeRoamQueue, ordersTheLargestNumbersAndClampsNegativeOnes) {
  const float values[] = {-1,
                          0,
                          std::numeric_limits<float>::min(),
                          1,
                          std::numeric_limits<float>::max(),
                          std::numeric_limits<float>::infinity()};
  TeRoamQueue queue(TeRoamQueue::Order::MostImportantFirst);
  for (int i = 0; i < 6; i++)
    queue.insert(i, std::uint32_t(i), values[i]);
  for (int i = 5; i >= 2; i--) {
    EXPECT_EQ(queue.top(), i);
    EXPECT_EQ(queue.topPriority(), values[i]);
    queue.remove(i);
  }
  EXPECT_EQ(queue.top(), 0); // as much as 1, which has a higher number
  EXPECT_EQ(queue.topPriority(), 0);
}
