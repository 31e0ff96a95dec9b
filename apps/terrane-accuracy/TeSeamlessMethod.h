#pragma once

#include "apps/terrane-accuracy/TeMeasuredMethod.h"
#include "apps/terrane-accuracy/TeMeasuredTerrain.h"
#include "nodes/TeNodePtr.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"
#include "nodes/seamless/TeSeamlessLists.h"
#include "nodes/seamless/TeSeamlessTerrain.h"

/// Seamless Patches over a height map; the dial is the document's precision factor.
class TeSeamlessMethod : public TeMeasuredMethod {
public:
  struct Settings {
    int minResolution = 16;
    int levels = 3;
    bool geomorph = false;
  };

  /// `terrain` must outlive it. Error: sizes that do not fit each other.
  static TeResult<std::unique_ptr<TeSeamlessMethod>> create(const TeMeasuredTerrain& terrain,
                                                            const Settings& settings);

  const std::string& name() const override { return m_name; }
  double bytesPerSample() const override;
  void select(const TeLodView& view, const TeDial& dial) override;
  TeSelected selected() const override;
  void appendMesh(std::vector<TeSeamlessMesh::Triangle>& triangles) const override;
  SoNode* node(const TeDial& dial) override;

  const TeSeamlessSelector& selector() const { return m_selector; }

private:
  TeSeamlessMethod(const TeMeasuredTerrain& terrain, const Settings& settings,
                   std::shared_ptr<const TeSeamlessBounds> bounds);

  const TeMeasuredTerrain& m_terrain;
  Settings m_settings;
  std::string m_name;
  TeSeamlessSelector m_selector;
  TeSeamlessParts m_parts;
  TeSeamlessPlacement m_placement;
  TeDial m_dial;
  TeSeamlessSelection m_selection;
  TeSeamlessLists m_lists;
  TeNodePtr<SoTeSeamlessPatches> m_node; ///< null until it is asked for
};
