#pragma once

#include "nodes/TeNodePtr.h"

#include <Inventor/nodes/SoTranslation.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>

/// What all SoTeTerrainMesh nodes of one terrain share: the point of the world that their vertices are
/// relative to (the *anchor*), and the account of their drawing.
///
/// A vertex that two meshes share has the same bits in both, under the same matrix, so that no pixel shows
/// between them. Vertices are float, so the anchor has to follow the viewer: beginAnchor() names the next
/// one; the meshes make their buffers for it bit by bit as they are drawn, within the frame's allowance; once
/// all have one, commitAnchor() moves all of them over between two frames. For the thread that makes all Coin
/// calls.
class TeMeshDrawing {
public:
  /// Of the frames since resetFrame().
  struct Frame {
    std::int64_t meshesDrawn = 0;
    std::int64_t meshesCulled = 0;
    std::int64_t triangles = 0;
    std::int64_t uploads = 0;
    std::int64_t bytesUploaded = 0;
    double uploadSeconds = 0; ///< CPU time of this thread
  };

  explicit TeMeshDrawing(glm::dvec2 anchor);

  glm::dvec2 anchor() const { return m_anchor; }
  /// The translation from the scene's origin to the anchor; comes before the meshes in the scene.
  SoTranslation* translation() const { return m_translation.get(); }
  /// The point of the world that is the scene's (0, 0, 0).
  void setWorldOrigin(glm::dvec3 origin);

  /// At once, for all meshes: their buffers are made anew when they are next drawn.
  void setAnchor(glm::dvec2 anchor);
  void beginAnchor(glm::dvec2 next);
  /// True between beginAnchor() and commitAnchor().
  bool changesAnchor() const { return m_changes; }
  glm::dvec2 nextAnchor() const { return m_nextAnchor; }
  /// True once no mesh is without a buffer for the next anchor.
  bool nextAnchorReady() const;
  void commitAnchor();

  /// Starts a new account. `anchorBytes`: how much may be uploaded for the next anchor until the next call.
  void resetFrame(std::size_t anchorBytes = 0);
  const Frame& frame() const { return m_frame; }
  /// In OpenGL buffers, all contexts together.
  std::size_t bufferBytes() const { return m_bufferBytes; }
  /// CPU seconds that an upload has taken per byte, lately.
  double secondsPerByte() const { return m_secondsPerByte; }

private:
  friend class SoTeTerrainMesh;

  TeNodePtr<SoTranslation> m_translation;
  glm::dvec2 m_anchor;
  glm::dvec2 m_nextAnchor{0};
  glm::dvec3 m_worldOrigin{0};
  bool m_changes = false;
  Frame m_frame;
  std::size_t m_anchorBytesLeft = 0;
  std::size_t m_bufferBytes = 0;
  double m_secondsPerByte = 1e-9;
};
