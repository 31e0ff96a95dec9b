#include "hard_cases/memory/TeFailingMemory.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

std::atomic<std::int64_t> allocationsDone{0};
std::atomic<std::int64_t> firstThatFails{kNever};
std::atomic<std::int64_t> lastThatFails{kNever};
std::atomic<std::int64_t> blocks{0};

void* allocate(std::size_t size) noexcept {
  const std::int64_t number = allocationsDone.fetch_add(1);
  if (number >= firstThatFails && number <= lastThatFails)
    return nullptr;
  void* block = std::malloc(size ? size : 1);
  blocks += block ? 1 : 0;
  return block;
}

void* allocateOrThrow(std::size_t size) {
  if (void* block = allocate(size))
    return block;
  throw std::bad_alloc();
}

void release(void* block) noexcept {
  blocks -= block ? 1 : 0;
  std::free(block);
}

} // namespace

TeFailingMemory::TeFailingMemory(std::int64_t first, Mode mode) {
  firstThatFails = kNever;
  allocationsDone = 0;
  lastThatFails = mode == Mode::One ? first : kNever;
  if (first >= 0)
    firstThatFails = first;
}

TeFailingMemory::~TeFailingMemory() { firstThatFails = kNever; }

std::int64_t TeFailingMemory::allocations() const { return allocationsDone; }

std::int64_t TeFailingMemory::blocksInUse() { return blocks; }

void* operator new(std::size_t size) { return allocateOrThrow(size); }
void* operator new[](std::size_t size) { return allocateOrThrow(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { release(block); }
