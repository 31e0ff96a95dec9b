#pragma once

#include "apps/terrane-view/TeViewOptions.h"
#include "nodes/TeNodePtr.h"
#include "nodes/lod/SoTeLodTerrain.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"

#include <string>
#include <vector>

class SoCamera;
class SoNode;

/// All LOD shapes of a scene, which the user changes together: wireframe, geomorphing, pixel error and the
/// camera that decides about detail of all, and what only SoTeSeamlessPatches have of these.
class TeLodNodes {
public:
  /// Finds them, and sets what the options say about accuracy and drawing.
  TeLodNodes(SoNode* scene, const TeViewOptions& options);

  bool any() const { return !m_shapes.empty(); }
  bool anySeamless() const { return !m_nodes.empty(); }
  const std::vector<TeNodePtr<SoTeLodTerrain>>& lodTerrains() const { return m_lodTerrains; }
  /// Of the last frame: counts, bytes and times summed up, the largest error bound and precision.
  TeSeamlessStatistics seamlessStatistics() const;
  /// The same with all SoTeLodTerrain, whose nodes are traversed, and parts rendered, as patches are.
  TeSeamlessStatistics statistics() const;
  /// Whether the next frame would be finer.
  bool areLoading() const;

  // What is set of the first; the node's defaults where there is none.
  bool instancing() const;
  bool geomorph() const;
  double precision() const;
  double pixelError() const; ///< 0 = the precision counts
  std::string colouring() const;

  void setInstancing(bool on);
  void setGeomorph(bool on);
  void setPrecision(double precision); ///< no pixel error is wanted from then on
  void setPixelError(double pixels);
  void setWireframe(bool on);
  /// Goes on to the next colouring for which the nodes have pictures.
  void nextColouring();
  /// The camera that decides about detail; null = the drawing one.
  void setLodCamera(SoCamera* camera);

private:
  std::vector<TeNodePtr<SoTeSeamlessPatches>> m_nodes;
  std::vector<TeNodePtr<SoTeLodTerrain>> m_lodTerrains;
  std::vector<TeNodePtr<SoTeLodShape>> m_shapes; ///< all of these
};
