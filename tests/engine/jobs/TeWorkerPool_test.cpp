#include "engine/jobs/TeWorkerPool.h"

#include <gtest/gtest.h>

#include <functional>
#include <new>

namespace {

class Task final : public TeWorkerTask {
public:
  explicit Task(std::function<TeStatus(const Task&)> work) : m_work(std::move(work)) {}

protected:
  TeStatus run() override { return m_work(*this); }

private:
  std::function<TeStatus(const Task&)> m_work;
};

std::unique_ptr<TeWorkerPool> pool(int threads) { return std::move(*TeWorkerPool::create(threads)); }

} // namespace

TEST(TeWorkerPool, RefusesImpossibleNumbersOfThreads) {
  for (int threads : {-1, 0, TeWorkerPool::kMaxThreads + 1})
    EXPECT_FALSE(TeWorkerPool::create(threads)) << threads;
  EXPECT_EQ(pool(3)->threads(), 3);
}

TEST(TeWorkerPool, RunsAllTasksAndShowsTheirResults) {
  for (int threads : {1, 4}) {
    const auto workers = pool(threads);
    std::vector<int> results(200, 0);
    std::vector<std::shared_ptr<Task>> tasks;
    for (int i = 0; i < 200; ++i) {
      tasks.push_back(std::make_shared<Task>([i, &results](const Task&) {
        results[std::size_t(i)] = i * i;
        return i % 2 ? TeStatus() : TeStatus(TeError{"even"});
      }));
      workers->submit(tasks.back());
    }
    workers->waitFor(*tasks[100]);
    EXPECT_EQ(results[100], 10000);
    workers->waitForAll();
    for (int i = 0; i < 200; ++i) {
      ASSERT_TRUE(tasks[std::size_t(i)]->ended());
      EXPECT_EQ(results[std::size_t(i)], i * i);
      EXPECT_EQ(tasks[std::size_t(i)]->status().ok(), i % 2 == 1);
    }
  }
}

TEST(TeWorkerPool, TasksThatWereCancelledDoNotBeginAndOthersNotice) {
  const auto workers = pool(1);
  std::atomic<bool> began{false};
  const auto long1 = std::make_shared<Task>([&](const Task& self) {
    began = true;
    while (!self.cancelled())
      std::this_thread::yield();
    return TeStatus();
  });
  const auto never = std::make_shared<Task>([](const Task&) {
    ADD_FAILURE() << "ran";
    return TeStatus();
  });
  workers->submit(long1);
  workers->submit(never);
  never->cancel();
  while (!began)
    std::this_thread::yield();
  EXPECT_FALSE(long1->ended());
  long1->cancel();
  workers->waitForAll();
  EXPECT_TRUE(long1->ended());
  EXPECT_TRUE(never->ended());
}

TEST(TeWorkerPool, ItsEndCancelsWhatRunsAndWaits) {
  std::atomic<int> left{0};
  std::weak_ptr<Task> last;
  {
    const auto workers = pool(2);
    for (int i = 0; i < 10; ++i) {
      const auto task = std::make_shared<Task>([&](const Task& self) {
        ++left;
        while (!self.cancelled())
          std::this_thread::yield();
        --left;
        return TeStatus();
      });
      last = task;
      workers->submit(task);
    }
  }
  EXPECT_EQ(left, 0);
  EXPECT_TRUE(last.expired());
}

TEST(TeWorkerPool, ALackOfMemoryIsAnError) {
  const auto workers = pool(1);
  const auto task = std::make_shared<Task>([](const Task&) -> TeStatus { throw std::bad_alloc(); });
  workers->submit(task);
  workers->waitFor(*task);
  ASSERT_FALSE(task->status());
  EXPECT_EQ(task->status().error().message, "out of memory");
}
