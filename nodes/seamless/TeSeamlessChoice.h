#pragma once

#include "nodes/lod/TeHeldView.h"
#include "nodes/seamless/TeSeamlessLists.h"
#include "nodes/seamless/TeSeamlessTerrain.h"

#include <cstdint>

/// What one viewer's frame draws, chosen again only when something has changed since the frame before.
///
/// The eye is held within holdRadius() (TeHeldView), but not with geomorphing, whose changes are smooth.
class TeSeamlessChoice {
public:
  /// Half the distance of samples: nothing that is drawn is finer.
  static double holdRadius(const TeSeamlessPlacement& placement) { return placement.spacing / 2; }

  /// The view for which update() would choose.
  TeLodView held(const TeSeamlessTerrainPtr& terrain, const TeLodView& view,
                 const TeSeamlessPlacement& placement, const TeSeamlessAccuracy& accuracy) const;

  /// True if the selection and the lists have been made anew; false if all that was given is as before.
  /// `parts`: the terrain's, with or without whole patches.
  bool update(const TeSeamlessTerrainPtr& terrain, const std::shared_ptr<const TeSeamlessParts>& parts,
              const TeLodView& view, const TeSeamlessPlacement& placement, const TeSeamlessAccuracy& accuracy,
              const TeClipResidency* residency);

  const TeSeamlessSelection& selection() const { return m_selection; }
  const TeSeamlessLists& lists() const { return m_lists; }
  /// View of the selection, with the held eye.
  const TeLodView& view() const { return m_view.view(); }
  /// CPU time of the last selection with its lists; how many there have been.
  double seconds() const { return m_seconds; }
  std::uint64_t selections() const { return m_selections; }

private:
  bool hasGround(const TeSeamlessTerrainPtr& terrain, const TeSeamlessPlacement& placement) const;

  TeSeamlessTerrainPtr m_terrain;
  std::shared_ptr<const TeSeamlessParts> m_parts;
  TeHeldView m_view;
  TeSeamlessPlacement m_placement;
  TeSeamlessAccuracy m_accuracy;
  bool m_isLimited = false; ///< by residency
  TeClipResidency m_residency;
  TeSeamlessSelection m_selection;
  TeSeamlessLists m_lists;
  double m_seconds = 0;
  std::uint64_t m_selections = 0;
};
