#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/terrain/TeMeshBuffers.h"
#include "nodes/terrain/TeMeshEye.h"

#include <Inventor/nodes/SoTranslation.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

/// What all SoTeTerrainMesh nodes of one terrain share: the point of the world that their vertices are
/// relative to (the *anchor*), and the account of their drawing.
///
/// A vertex that two meshes share has the same bits in both, under the same matrix, so that no pixel shows
/// between them. Vertices are float, so the anchor has to follow the viewer: beginAnchor() names the next
/// one; the meshes make their buffers for it bit by bit as they are drawn, within the frame's allowance; once
/// all have one, commitAnchor() moves all of them over between two frames. For the thread that makes all Coin
/// calls; anchors and origins are finite.
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
    /// No sample that was drawn deviates by more, in pixels (TeLodView::pixels()); 0 with all triangles.
    double errorBound = 0;
  };

  explicit TeMeshDrawing(glm::dvec2 anchor);
  /// Its OpenGL buffers go when their contexts are next drawn in, or go.
  ~TeMeshDrawing();
  TeMeshDrawing(const TeMeshDrawing&) = delete;
  TeMeshDrawing& operator=(const TeMeshDrawing&) = delete;

  glm::dvec2 anchor() const { return m_anchor; }
  /// The translation from the scene's origin to the anchor; comes before the meshes in the scene.
  SoTranslation* translation() const { return m_translation.get(); }
  /// The point of the world that is the scene's (0, 0, 0); (0, 0, 0) at first.
  void setWorldOrigin(glm::dvec3 origin);

  /// At once, for all meshes: their buffers are made anew when they are next drawn. Ends a change of anchor.
  void setAnchor(glm::dvec2 anchor);
  /// Starts a change of anchor, or starts it over with another one.
  void beginAnchor(glm::dvec2 next);
  /// True between beginAnchor() and commitAnchor().
  bool changesAnchor() const { return m_changes; }
  glm::dvec2 nextAnchor() const { return m_nextAnchor; }
  /// True once a frame was drawn, after beginAnchor(), in which no mesh lacked a buffer for the next anchor.
  bool nextAnchorReady() const;
  /// During a change only. A mesh that still lacks its buffer makes it when it is next drawn. Buffers for
  /// the anchor before go in the next frames, kFreedPerFrame in each.
  void commitAnchor();

  /// The screen error that coarser levels may have, pixels: each mesh is drawn with the coarsest level of
  /// which no sample deviates by more (TeGridLevels). 0, as at first: with all triangles; no level is then
  /// made, and nothing kept. Not negative; finite.
  void setPixelError(double pixels);
  double pixelError() const { return m_pixelError; }
  /// The levels of whole grids of a size, made when first asked for; shared.
  std::shared_ptr<const TeGridLevels> gridLevels(int columns, int rows);

  /// Starts a new account. `anchorBytes`: how much may be uploaded for the next anchor until the next call;
  /// if it is not 0, at least one mesh is.
  void resetFrame(std::size_t anchorBytes = 0);
  const Frame& frame() const { return m_frame; }
  /// In OpenGL buffers, all contexts together, with those that wait for their context to be freed in.
  std::size_t bufferBytes() const;
  /// CPU seconds that uploads have taken per byte, lately; a guess before the first.
  double secondsPerByte() const { return m_secondsPerByte; }
  /// CPU seconds that the upload of a mesh will take, judged by the latest ones, rather too many than too
  /// few. A small mesh costs hardly less than a large one.
  double uploadSeconds(std::size_t bytes) const {
    return kCaution * (m_secondsPerUpload + kCopySeconds * double(bytes));
  }

private:
  static constexpr double kCopySeconds = 2e-10; ///< to copy a byte
  static constexpr double kCaution = 1.5;

  friend class SoTeTerrainMesh;

  /// The buffers of a context, which is current.
  TeMeshBuffers& buffers(std::uint32_t context);
  /// A node goes, or gets another mesh.
  void forget(const void* node);
  /// Makes what a mesh lacks. Null if this OpenGL cannot draw it.
  TeMeshBuffers::Mesh* prepare(TeMeshBuffers& buffers, const void* node, const TePatchMesh& mesh,
                               const std::vector<std::uint32_t>& colours);
  /// Makes a level's indices if they are not there.
  void prepareLevel(TeMeshBuffers& buffers, const TeMeshBuffers::Mesh& made, const TeGridLevels& levels,
                    int level);
  void prepareNextAnchor(TeMeshBuffers& buffers, TeMeshBuffers::Mesh& made, const TePatchMesh& mesh);
  /// Accounts for an upload that began at `start`, CPU seconds.
  void count(std::size_t bytes, double start);
  void updateTranslation();
  /// Errors that a mesh lacks, because none were wanted when it was made; a few in a frame.
  bool mayFindErrors(std::size_t vertices);
  static void freeWhenCurrent(const std::shared_ptr<TeMeshBuffers>& buffers);
  static void onContextDestroyed(std::uint32_t context, void* drawing);

  static constexpr int kFreedPerFrame = 64;
  static constexpr std::size_t kErrorVertices = 4096; ///< of meshes whose errors are found in a frame

  TeNodePtr<SoTranslation> m_translation;
  glm::dvec2 m_anchor;
  glm::dvec2 m_nextAnchor{0};
  glm::dvec3 m_worldOrigin{0};
  bool m_changes = false;
  bool m_wasReady = false;     ///< at the end of a frame since beginAnchor()
  std::int64_t m_withNext = 0; ///< meshes of this frame that have a buffer for the next anchor
  std::int64_t m_withoutNext = 0;
  std::size_t m_anchorBytesLeft = 0;
  int m_freesLeft = kFreedPerFrame;
  double m_pixelError = 0;
  std::size_t m_errorVerticesLeft = kErrorVertices;
  TeMeshEye m_eye;                                                             ///< of the action that draws
  std::map<std::pair<int, int>, std::shared_ptr<const TeGridLevels>> m_levels; ///< by columns and rows
  Frame m_frame;
  double m_recentSeconds = 0; ///< of uploads, fading
  double m_recentBytes = 0;
  double m_recentUploads = 0;
  double m_secondsPerByte = 2e-9;
  double m_secondsPerUpload = 2e-5;
  std::map<std::uint32_t, std::shared_ptr<TeMeshBuffers>> m_buffers; ///< by context
};
