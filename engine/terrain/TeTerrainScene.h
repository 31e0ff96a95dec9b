#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/terrain/SoTeTerrainMesh.h"

#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSeparator.h>

#include <glm/vec3.hpp>

#include <memory>

/// The terrain's part of the scene: one group a patch, below one translation.
///
/// The scene's (0, 0, 0) is a point of the world near the eye (the *origin*), and meshes have vertices
/// relative to another (the anchor, see TeMeshDrawing). Both are patch corners and follow the eye in steps,
/// so that floats stay small: what is drawn is placed to about 2^-24 of kAnchorPatches patches, wherever in
/// the world it is.
class TeTerrainScene {
public:
  /// Farthest that the eye may be from the origin and the anchor, in patches.
  static constexpr double kOriginPatches = 8;
  static constexpr double kAnchorPatches = 128;
  static constexpr double kHighest = 1e30; ///< of the origin, metres, so that floats stay finite
  /// Without a frame drawn in so many ticks nobody looks, and a change of the anchor need not wait for
  /// frames.
  static constexpr int kUndrawnTicks = 30;

  TeTerrainScene(const TeLattice& lattice, const glm::dvec3& eye);

  SoSeparator* root() const { return m_root.get(); }
  const std::shared_ptr<TeMeshDrawing>& drawing() const { return m_drawing; }
  const glm::dvec3& origin() const { return m_origin; }

  /// Once a tick; outside the world all stays where it is. True if the origin has moved: everything placed
  /// relative to it has to be placed anew. `reach`: the terrain's half side in patches.
  bool follow(const glm::dvec3& eye, int reach);
  /// Moves everything at once, after a jump.
  void jump(const glm::dvec3& eye);
  /// Completes a change of the anchor that has begun.
  void finishAnchor();

  void add(SoGroup* patch);
  void remove(SoGroup* patch);
  void setWireframe(bool wireframe);

private:
  glm::dvec2 cornerNear(const glm::dvec3& point) const;
  void setOrigin(const glm::dvec3& eye);

  TeLattice m_lattice;
  glm::dvec3 m_origin{0};
  int m_undrawn = 0; ///< ticks since a frame was drawn, while the anchor changes
  std::shared_ptr<TeMeshDrawing> m_drawing;
  TeNodePtr<SoSeparator> m_root;
  TeNodePtr<SoDrawStyle> m_style;
  TeNodePtr<SoGroup> m_patches;
};
