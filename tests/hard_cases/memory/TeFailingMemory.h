#pragma once

#include <cstdint>

/// Lets allocations of this program (operator new, in any thread) fail by their number.
class TeFailingMemory {
public:
  enum class Mode { One, AllFromThere };

  /// From now on allocation number `first` fails, counted from 0; or that and all after it. -1 = none.
  TeFailingMemory(std::int64_t first, Mode mode);
  ~TeFailingMemory(); ///< none fails any more
  TeFailingMemory(const TeFailingMemory&) = delete;
  TeFailingMemory& operator=(const TeFailingMemory&) = delete;

  /// Allocations since it was made.
  std::int64_t allocations() const;
  /// Blocks that were allocated and not freed, of the whole program.
  static std::int64_t blocksInUse();
};
