#pragma once

#include "engine/jobs/TeJobKind.h"
#include "engine/jobs/TeJobState.h"

#include <array>
#include <cstddef>
#include <cstdint>

/// The one record of what an engine has done (contract 12): feeds the HUD, the reports of applications and
/// the benchmarks. Times are seconds of CPU time of the engine's thread unless it says otherwise.
struct TeStatistics {
  struct Jobs {
    /// Jobs in the queue now, by kind and state.
    std::array<std::array<std::int64_t, kTeJobStates>, kTeJobKinds> now{};
    std::array<std::int64_t, kTeJobKinds> started{};
    std::array<std::int64_t, kTeJobKinds> finished{};
    std::array<std::int64_t, kTeJobKinds> cancelled{};
    std::array<std::int64_t, kTeJobKinds> failed{};
    std::int64_t mapsMade = 0;
    std::int64_t mapsShared = 0; ///< asked for while they were being made, or in memory already
  };
  struct Patches {
    std::int64_t resident = 0; ///< with heights
    std::int64_t block = 0;    ///< belong into the scene now
    std::int64_t drawn = 0;    ///< are in the scene
    std::int64_t missing = 0;  ///< of the block, not in the scene
    std::int64_t missingInView = 0;
    std::int64_t made = 0;
    std::int64_t madeAgain = 0;
    std::int64_t dropped = 0;
  };
  struct Drawing { ///< of the last frame drawn
    std::int64_t meshesDrawn = 0;
    std::int64_t meshesCulled = 0;
    std::int64_t triangles = 0;
    std::int64_t uploads = 0;
    std::int64_t bytesUploaded = 0;
    double uploadSeconds = 0;
    double seconds = 0; ///< that drawing took without uploads; only with a quality goal
  };
  struct Memory { ///< bytes now
    std::size_t maps = 0;
    std::size_t heights = 0;
    std::size_t meshes = 0;  ///< plain arrays
    std::size_t buffers = 0; ///< of OpenGL
    std::size_t records = 0; ///< of what was made with which source
    std::size_t total() const { return maps + heights + meshes + buffers + records; }
  };

  std::int64_t ticks = 0;
  double simulatedSeconds = 0;
  double droppedSeconds = 0; ///< of dt that was too long to simulate
  double budgetSeconds = 0;  ///< of the next tick
  double tickSeconds = 0;    ///< the last tick, with the uploads that it led to
  double worstTickSeconds = 0;
  double frameSeconds = 0; ///< of the wall clock, the last frame
  std::int64_t ticksOverBudget = 0;
  std::int64_t slicesOverrun = 0; ///< of work by time that ended more than one smallest unit (0.25 ms) late
  double longestUnitSeconds = 0;
  std::int64_t framesWithoutGround = 0; ///< ticks that ended with no known patch below the active object
  std::int64_t framesWithMissingInView = 0;
  /// Of these, those after the block had been complete once, at the start or since the last jump.
  std::int64_t framesWithMissingLater = 0;
  std::int64_t ticksUntilComplete = 0; ///< from the start or the last jump to the complete block, or to now
  std::int64_t objectsHeld = 0;        ///< updates that were left out for want of ground
  std::int64_t redraws = 0;            ///< frames in which something had changed
  double heightAboveGround = 0;        ///< of the active object; NaN if the ground is not known
  /// Of what was drawn last, against the surface of the base level: no sample deviates by more.
  double errorBoundPixels = 0;
  double pixelError = 0;       ///< that is wanted
  double frameGoalSeconds = 0; ///< of the wall clock; 0 = no quality goal
  Jobs jobs;
  Patches patches;
  Drawing drawing;
  Memory memory;
  Memory peak; ///< the largest of each
};
