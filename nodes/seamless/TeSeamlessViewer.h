#pragma once

#include "nodes/seamless/TeSeamlessChoice.h"
#include "nodes/seamless/TeSeamlessClip.h"
#include "nodes/seamless/TeSeamlessScene.h"

#include <cstdint>
#include <memory>

/// Who looks at a terrain from one place in one context: what he has of its clipmaps, and what is chosen for
/// him.
struct TeSeamlessViewer {
  TeSeamlessChoice choice;
  std::shared_ptr<TeSeamlessClip> heights; ///< null without clipmaps
  std::shared_ptr<TeSeamlessClip> colours;
  std::uint64_t lastUse = 0;

  /// Makes what is missing of the clipmaps and moves them toward an eye, in the terrain's coordinates. Error:
  /// a clipmap that cannot be made.
  TeStatus follow(const TeSeamlessScene& scene, std::uint32_t context, const glm::dvec3& eye, bool inBudget);
  /// Brings both to the GPU; the context is current. Error: OpenGL cannot have them.
  TeStatus upload();
  /// Whether there is more to come without any move.
  bool isSettled() const;
  const TeClipResidency* residency() const { return heights ? &heights->residency() : nullptr; }
  std::int64_t bytesUploaded() const; ///< so far

  /// Gives up what is in OpenGL: now if the context is current, else when it is next.
  void release(bool isCurrent);
};
