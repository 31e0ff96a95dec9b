#pragma once

#include "nodes/lod/drawing/TeLodViewers.h"

#include <Inventor/SbLine.h>

#include <glm/vec3.hpp>

#include <vector>

class SoNode;
class SoRayPickAction;

/// What a ray meets of a terrain: the triangles that are drawn; where none are, the surface of all samples.
/// Hits have a SoTeTerrainDetail, whose key is the cell of samples.
class TeLodRays {
public:
  /// All must outlive it. The action's ray is in the coordinates of the node (setObjectSpace()). `origin`: of
  /// the node, in the world.
  TeLodRays(SoNode& node, SoRayPickAction& action, TeLodViewers& viewers, const glm::dvec3& origin);

  void pick();

private:
  struct Hit {
    SbVec3f point;
    SbVec3f corners[3];
    bool isCovered = false;
  };

  /// False if the ray passes a triangle by, for sure.
  bool mayMeet(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  void place(const TeLodMesh& part);
  void findHits(const TeLodMesh& part, std::vector<Hit>& hits);
  /// Marks the hits under or above a part's triangles.
  void cover(const TeLodMesh& part, std::vector<Hit>& hits) const;
  glm::dvec3 samples(const SbVec3f& point) const;
  void add(const Hit& hit);
  /// Whether no part of the ray that may be picked lies out of view.
  bool staysInView(const TeLodView& view) const;

  SoNode& m_node;
  SoRayPickAction& m_action;
  TeLodViewers& m_viewers;
  glm::dvec3 m_origin;
  SbLine m_line;
  glm::dvec3 m_start{0};
  glm::dvec3 m_ahead{0};
  glm::dvec3 m_across{0}; ///< the ray is where two planes meet, with these normals
  glm::dvec3 m_up{0};
  double m_margin = 0;

  struct Side {
    double across = 0;
    double up = 0;
  };
  std::vector<SbVec3f> m_points; ///< of the part in work
  std::vector<Side> m_sides;
};
