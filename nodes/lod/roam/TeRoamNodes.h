#pragma once

#include "nodes/lod/TeLodMesh.h"
#include "nodes/lod/roam/TeRoamBounds.h"
#include "nodes/lod/roam/TeRoamBoxes.h"

#include <cstdint>
#include <vector>

/// A triangle of a mesh: split, or a leaf. Other nodes and vertices are places in the arrays of TeRoamNodes.
struct TeRoamNode {
  static constexpr std::int32_t kNone = -1;
  static constexpr std::int32_t kRim = -2; ///< beyond the terrain

  TeRoamTriangle triangle;
  std::uint32_t number = 0; ///< of the triangle
  std::int32_t parent = kNone;
  std::int32_t children = kNone; ///< the first of four; none: a leaf
  /// Across each edge, of the same level; none if that triangle does not exist, its parent being a leaf.
  std::int32_t neighbours[3] = {kNone, kNone, kNone};
  std::uint8_t childNumber = 0;
  /// Of a split node: how many split nodes need it to stay split. Those are its children, and the children of
  /// its neighbours, that are split and have an edge on it.
  std::uint8_t locks = 0;

  bool isLeaf() const { return children < 0; }
};

/// What a node is drawn with: vertices at its corners and, for an edge whose neighbour is split, in the
/// middle of it; elsewhere any vertex. Apart from the rest, so that drawing a mesh reads no more than this.
struct TeRoamPoints {
  std::int32_t vertices[6] = {0, 0, 0, 0, 0, 0}; ///< as in TeRoamFan
  std::uint8_t edges = 0;                        ///< bit k: the neighbour across edge k is split
};

/// The triangles that exist, and their vertices: pools without holes to speak of, since what is freed is used
/// again first. The children of a triangle stay together, so that they are made, and measured, at once.
class TeRoamNodes {
public:
  explicit TeRoamNodes(std::shared_ptr<const TeRoamBounds> bounds);

  /// The two triangles of the base, 0 and 1.
  void reset();
  std::size_t size() const { return m_nodes.size(); } ///< with free ones, whose error is negative
  std::int64_t live() const { return m_live; }
  std::size_t bytes() const;

  TeRoamNode& operator[](std::int32_t node) { return m_nodes[std::size_t(node)]; }
  const TeRoamNode& operator[](std::int32_t node) const { return m_nodes[std::size_t(node)]; }
  const TeRoamPoints& points(std::int32_t node) const { return m_points[std::size_t(node)]; }
  const TeRoamBounds& bounds() const { return *m_bounds; }
  const TeRoamBoxes& boxes() const { return m_boxes; }
  const std::vector<float>& variances() const { return m_variances; }     ///< by node, if bounds() has them
  const std::vector<TeLodVertex>& vertices() const { return m_vertices; } ///< with free ones
  int deepest() const { return m_bounds->field().cellsLog(); }            ///< level that cannot be split

  /// Four leaves with links to their parent, which is a leaf yet, to each other and to the children of its
  /// neighbours; these links lead back. References to nodes become invalid. Returns the first.
  std::int32_t makeChildren(std::int32_t parent);
  /// Undoes that.
  void freeChildren(std::int32_t parent);

private:
  std::int32_t takeFour();
  std::int32_t makeVertex(const TeRoamTriangle::Point& point);
  void describe(std::int32_t node);
  void linkChildren(std::int32_t parent, const std::int32_t (&middles)[3]);

  std::shared_ptr<const TeRoamBounds> m_bounds;
  std::vector<TeRoamNode> m_nodes;
  std::vector<TeRoamPoints> m_points; ///< by node, as the following
  TeRoamBoxes m_boxes;
  std::vector<float> m_variances;
  std::vector<TeLodVertex> m_vertices;
  std::vector<std::int32_t> m_freeFours;
  std::vector<std::int32_t> m_freeVertices;
  std::int64_t m_live = 0;
};
