#pragma once

#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/drawing/TeLodLook.h"
#include "nodes/lod/drawing/TeLodPartStore.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <unordered_set>
#include <vector>

/// Draws what a LOD method has selected, for one viewer in one context.
///
/// Parts are made once and kept by their keys; but where most of the new parts of a selection are gone with
/// the next one (a mesh that changes everywhere, as ROAM's), new parts are sent once and kept only if they
/// are drawn again. Vertices are relative to an anchor, a point near the eye that moves after kReach samples;
/// then all is made anew. They share one matrix, made in double precision: vertices that parts share have the
/// same bits, and nothing trembles far from the origin.
///
/// All calls with the context current, except context() and isUsable().
class TeLodRenderer {
public:
  static constexpr int kReach = 1024; ///< samples

  struct Counts {
    std::int64_t triangles = 0;
    std::int64_t drawCalls = 0;
    std::int64_t bytesSent = 0;
    std::int64_t keptParts = 0;
    std::size_t keptBytes = 0;
  };

  /// For the current context. One line in TeLog if it cannot be drawn in.
  explicit TeLodRenderer(std::uint32_t context)
      : m_context(context), m_isUsable(m_gl.load(context)), m_sender(m_gl), m_parts(m_sender) {}
  TeLodRenderer(const TeLodRenderer&) = delete;
  TeLodRenderer& operator=(const TeLodRenderer&) = delete;

  std::uint32_t context() const { return m_context; }
  bool isUsable() const { return m_isUsable; }

  /// Draws the method's selection; `selection` counts the selections, of this method since it lives.
  /// `eyeFromField`: from the field's coordinates to those of the eye, in glm's order. Nothing is drawn if
  /// that has no inverse or is not finite. Leaves all state of OpenGL as it was but the current colour and
  /// normal.
  Counts draw(const TeLodMethod& method, std::uint64_t selection, const TeLodLook& look,
              const glm::dmat4& eyeFromField);
  /// Gives up all that it has in OpenGL; also needed before another method is drawn.
  void freeAll();

private:
  void placeAnchor(const TeLodField& field, const glm::dvec3& eye);
  void learn(const TeLodSelection& selection);
  void sendParts(const TeLodMethod& method, const TeLodLook& look, bool isNewSelection);

  std::uint32_t m_context;
  TeLodGl m_gl;
  bool m_isUsable;
  TeLodSender m_sender;
  TeLodPartStore m_parts;

  bool m_hasAnchor = false;
  glm::dvec3 m_anchor{0};
  TeLodSubmission m_submission = TeLodSubmission::VboStatic;
  bool m_hasColours = false;
  std::uint64_t m_selection = 0;
  bool m_keepsNew = true;                       ///< new parts are expected to stay
  std::unordered_set<std::uint64_t> m_newKeys;  ///< of the last selection
  std::unordered_set<std::uint64_t> m_sentOnce; ///< in the last frame
  std::vector<TeLodArrays> m_once;              ///< the first m_onceCount of them
  std::size_t m_onceCount = 0;
  TeLodMesh m_mesh;
};
