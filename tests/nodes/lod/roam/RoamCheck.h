#pragma once

#include "nodes/lod/roam/RoamWorld.h"

#include <optional>
#include <string>
#include <vector>

/// Checks everything that a TeRoamMesh promises, from the places of triangles alone. Empty: all is well.
class RoamCheck {
public:
  explicit RoamCheck(const TeRoamMesh& mesh) : m_mesh(mesh), m_nodes(mesh.nodes()) {}

  std::string fault() {
    if (!m_mesh.splits().isConsistent() || !m_mesh.merges().isConsistent())
      return "a queue is no heap";
    m_byNumber.assign(TeRoamTriangle::firstNumber(m_nodes.deepest() + 1), TeRoamNode::kNone);
    m_found.clear();
    for (const std::int32_t base : {0, 1})
      collect(base, TeRoamNode::kNone);
    if (std::int64_t(m_found.size()) != m_nodes.live())
      return "live() is not the number of triangles";
    for (const std::int32_t node : m_found)
      if (const char* wrong = faultOf(node))
        return wrong + (" at " + std::to_string(m_nodes[node].number));
    return faultOfQueues();
  }

private:
  void collect(std::int32_t node, std::int32_t parent) {
    m_found.push_back(node);
    m_byNumber[m_nodes[node].number] = node;
    m_parents.resize(std::max(m_parents.size(), std::size_t(node) + 1));
    m_parents[std::size_t(node)] = parent;
    if (!m_nodes[node].isLeaf())
      for (int k = 0; k < 4; k++)
        collect(m_nodes[node].children + k, node);
  }

  /// Across an edge, wherever it exists or not; none beyond the terrain.
  static std::optional<TeRoamTriangle> across(const TeRoamTriangle& t, int edge) {
    TeRoamTriangle other{t.level, t.x, t.y, !t.upper};
    if (edge == 0)
      other.y += t.upper ? 1 : -1;
    if (edge == 1)
      other.x += t.upper ? -1 : 1;
    const int squares = 1 << t.level;
    if (other.x < 0 || other.y < 0 || other.x >= squares || other.y >= squares)
      return {};
    return other;
  }

  /// The children on the edge, of a split triangle, are leaves.
  bool hasLeavesAlong(std::int32_t node, int edge) const {
    return m_nodes[m_nodes[node].children + edge].isLeaf() &&
           m_nodes[m_nodes[node].children + (edge + 1) % 3].isLeaf();
  }

  bool isMiddle(std::int32_t number, int edge) const {
    const TeRoamTriangle::Point middle = m_nodes[number].triangle.middle(edge, m_nodes.deepest());
    const TeLodVertex& vertex = m_nodes.vertices()[std::size_t(m_nodes.points(number).vertices[3 + edge])];
    return vertex.column == middle.column && vertex.row == middle.row;
  }

  const char* faultOf(std::int32_t number) const {
    const TeRoamNode& node = m_nodes[number];
    const std::int32_t parent = m_parents[std::size_t(number)];
    if (node.parent != parent)
      return "parent";
    if (node.number != node.triangle.number())
      return "number";
    if (parent >= 0) {
      if (node.number != TeRoamTriangle::childOf(m_nodes[parent].number, node.childNumber))
        return "child number";
      if (m_mesh.priority(number) > m_mesh.priority(parent))
        return "priority above the parent's";
    }
    for (int k = 0; k < 3; k++) {
      const TeRoamTriangle::Point corner = node.triangle.corner(k, m_nodes.deepest());
      const TeLodVertex& vertex = m_nodes.vertices()[std::size_t(m_nodes.points(number).vertices[k])];
      if (vertex.column != corner.column || vertex.row != corner.row)
        return "vertex";
    }
    bool isFree = !node.isLeaf(); // nothing that it is needed for is split
    for (int k = 0; k < 4 && !node.isLeaf(); k++)
      isFree = isFree && m_nodes[node.children + k].isLeaf();
    for (int edge = 0; edge < 3; edge++) {
      const std::optional<TeRoamTriangle> other = across(node.triangle, edge);
      const std::int32_t wanted = other ? m_byNumber[other->number()] : TeRoamNode::kRim;
      if (node.neighbours[edge] != wanted)
        return "neighbour";
      const bool isSplit = wanted >= 0 && !m_nodes[wanted].isLeaf();
      if ((m_nodes.points(number).edges >> edge & 1) != (isSplit ? 1 : 0))
        return "edge point";
      if (isSplit && !isMiddle(number, edge))
        return "vertex of an edge point";
      if (!node.isLeaf() && wanted == TeRoamNode::kNone)
        return "a neighbour of a split triangle is missing";
      if (node.isLeaf() && isSplit && !hasLeavesAlong(wanted, edge))
        return "levels differ by two";
      if (isSplit && !node.isLeaf())
        isFree = isFree && hasLeavesAlong(wanted, edge);
    }
    if (!node.isLeaf() && isFree != (node.locks == 0))
      return "locks";
    const bool canSplit = node.isLeaf() && node.triangle.level < m_nodes.deepest();
    if (m_mesh.splits().contains(number) != canSplit)
      return "split queue";
    if (m_mesh.merges().contains(number) != isFree)
      return "merge queue";
    if (m_mesh.fan(number) != (node.isLeaf() ? TeRoamFan::all()[m_nodes.points(number).edges].count : 0))
      return "fan";
    return nullptr;
  }

  std::string faultOfQueues() const {
    std::size_t splits = 0, merges = 0;
    std::int64_t drawn = 0;
    float most = 0, least = std::numeric_limits<float>::infinity();
    for (const std::int32_t node : m_found) {
      if (m_mesh.splits().contains(node)) {
        splits++;
        most = std::max(most, m_mesh.priority(node));
      }
      if (m_mesh.merges().contains(node)) {
        merges++;
        least = std::min(least, std::max(0.0f, m_mesh.priority(node)));
      }
      drawn += m_mesh.isSeen(node) ? m_mesh.fan(node) : 0;
    }
    if (splits != m_mesh.splits().size() || merges != m_mesh.merges().size())
      return "a queue holds what is gone";
    if (splits > 0 && most != m_mesh.splits().topPriority())
      return "the split queue's top";
    if (merges > 0 && least != m_mesh.merges().topPriority())
      return "the merge queue's top";
    return drawn == m_mesh.drawn() ? "" : "drawn()";
  }

  const TeRoamMesh& m_mesh;
  const TeRoamNodes& m_nodes;
  std::vector<std::int32_t> m_found;
  std::vector<std::int32_t> m_parents;  ///< by node, as found from above
  std::vector<std::int32_t> m_byNumber; ///< of triangles
};
