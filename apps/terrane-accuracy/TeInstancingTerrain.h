#pragma once

#include "apps/terrane-accuracy/TeMeasuredTerrain.h"
#include "nodes/TeNodePtr.h"
#include "nodes/clipmap/SoTeClipmap.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"
#include "nodes/seamless/TeSeamlessBounds.h"

#include <memory>
#include <string>

/// A large terrain for Seamless Patches: a map in memory, or a pyramid on disk seen through clipmaps.
class TeInstancingTerrain {
public:
  static TeResult<TeInstancingTerrain> ofMap(TeMeasuredTerrain map);
  /// Heights of NAME_i.raw, the highest level that there is. Error: none that can be used.
  static TeResult<TeInstancingTerrain> ofPyramid(const std::string& name, double spacing, double heightScale,
                                                 int clipSize);

  const std::string& name() const { return m_name; }
  int cells() const { return m_cells; }
  double spacing() const { return m_spacing; }
  double heightScale() const { return m_heightScale; }
  int clipSize() const { return m_clipmap ? m_clipmap->size.getValue() : 0; } ///< 0: no clipmaps

  /// Of the flight over all samples. The terrain must outlive it.
  TeFlyover flyover() const;
  /// For layouts of cells() or, of a pyramid, a lower level; from the file beside the pyramid if it is there.
  TeResult<std::shared_ptr<const TeSeamlessBounds>> bounds(const TeSeamlessLayout& layout,
                                                           const TeSeamlessBounds::Progress& progress) const;
  /// What is resident around a viewer; null if all of it is always.
  TeResult<std::unique_ptr<TeClipWindows>> windows(const TeSeamlessLayout& layout) const;
  /// Draws it with corner (0, 0).
  TeNodePtr<SoTeSeamlessPatches> node(const TeSeamlessLayout& layout) const;

private:
  TeInstancingTerrain() = default;
  float sample(std::int32_t column, std::int32_t row) const;

  std::string m_name;
  int m_cells = 0;
  double m_spacing = 1;
  double m_heightScale = 1;
  std::shared_ptr<const TeMeasuredTerrain> m_map; ///< or
  TeNodePtr<SoTeClipmap> m_clipmap;
};
