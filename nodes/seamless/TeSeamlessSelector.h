#pragma once

#include "nodes/clipmap/TeClipResidency.h"
#include "nodes/lod/TeLodView.h"
#include "nodes/seamless/TeSeamlessBounds.h"
#include "nodes/seamless/TeSeamlessSelection.h"

#include <glm/vec3.hpp>

#include <memory>

/// Where the samples lie: sample (column, row) of height h is drawn at corner + (column·spacing, row·spacing,
/// h·heightScale). Metres.
struct TeSeamlessPlacement {
  glm::dvec3 corner{0};
  double spacing = 1;     ///< more than 0
  double heightScale = 1; ///< not negative
  /// Of all samples, for boxes and distances where there are no TeSeamlessBounds.
  TeHeightRange range;
};

/// How accurate a frame is to be.
struct TeSeamlessAccuracy {
  double precision = 2;  ///< the document's factor p, from 1
  double pixelError = 0; ///< wanted screen error in pixels, in place of precision if more than 0
  bool exact = false;    ///< every sample in view, in place of both
  bool geomorph = false;
  int maxPatches = 20000; ///< budget of patches drawn, from 1
  /// By how much heights that are drawn may differ from their samples, in the unit of these (the format of a
  /// texture): part of the frame's errorBound, but not of what pixelError asks for.
  double rounding = 0;
};

/// Chooses patches and the resolutions of their sides for a view: Seamless Patches, docs/seamless-patches.md.
/// All it decides about a side is a function of that side and the view, so that neighbours agree without
/// being asked, whether or not they are in view; what is drawn fits without cracks.
///
/// Thread-safe. Cost: in proportion to the patches looked at, none to the terrain's size.
class TeSeamlessSelector {
public:
  /// `bounds` may be null: boxes are then as high as the whole terrain, and there is no pixelError.
  TeSeamlessSelector(const TeSeamlessLayout& layout, std::shared_ptr<const TeSeamlessBounds> bounds);

  const TeSeamlessLayout& layout() const { return m_layout; }
  const TeSeamlessBounds* bounds() const { return m_bounds.get(); }

  /// `residency`: what of the heights can be drawn; null means all. Replaces `selection`, whose memory is
  /// used again.
  void select(const TeLodView& view, const TeSeamlessPlacement& placement, const TeSeamlessAccuracy& accuracy,
              const TeClipResidency* residency, TeSeamlessSelection& selection) const;

private:
  TeSeamlessLayout m_layout;
  std::shared_ptr<const TeSeamlessBounds> m_bounds;
};
