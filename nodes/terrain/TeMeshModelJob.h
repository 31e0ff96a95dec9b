#pragma once

#include "generators/TeHeightSource.h"
#include "nodes/TeNodePtr.h"
#include "nodes/TeSurfaceColours.h"
#include "nodes/terrain/SoTeTerrainMesh.h"

/// Makes a SoTeTerrainMesh from a mesh in slices of some rows of vertices: colours, then the node.
class TeMeshModelJob {
public:
  TeMeshModelJob(TePatchMeshPtr mesh, const TeSurfaceColours& colours,
                 std::shared_ptr<TeMeshDrawing> drawing);

  /// True when done. Units of at most about 4096 vertices.
  bool step(TeAllowance& allowance);
  /// Once done.
  TeNodePtr<SoTeTerrainMesh> take();

private:
  TePatchMeshPtr m_mesh;
  TeSurfaceColours m_surfaceColours;
  std::shared_ptr<TeMeshDrawing> m_drawing;
  std::vector<std::uint32_t> m_colours;
};
