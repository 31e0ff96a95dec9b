#pragma once

#include "generators/base/TeAllowance.h"
#include "nodes/TeNodePtr.h"
#include "nodes/TeSurfaceColours.h"
#include "nodes/terrain/SoTeTerrainMesh.h"
#include "nodes/terrain/TeLevelErrors.h"

#include <optional>

/// Makes a SoTeTerrainMesh from a mesh in slices of some rows of vertices: colours, then, if the drawing has
/// a pixel error, the errors of its levels, then the node.
class TeMeshModelJob {
public:
  TeMeshModelJob(TePatchMeshPtr mesh, const TeSurfaceColours& colours,
                 std::shared_ptr<TeMeshDrawing> drawing);

  /// Colours vertices until the allowance is spent, in units of at most kVerticesPerUnit; true when done. On
  /// any thread, one at a time, while nobody changes the drawing.
  bool step(TeAllowance& allowance);
  /// Once done, once; on the thread that makes all Coin calls. Looks at all vertices for their bounding box.
  TeNodePtr<SoTeTerrainMesh> take();

  static constexpr std::size_t kVerticesPerUnit = 4096;

private:
  TePatchMeshPtr m_mesh;
  TeSurfaceColours m_surfaceColours;
  std::shared_ptr<TeMeshDrawing> m_drawing;
  std::vector<std::uint32_t> m_colours;
  std::optional<TeLevelErrors> m_errors; ///< if they are wanted
};
