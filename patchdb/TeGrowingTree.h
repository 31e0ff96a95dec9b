#pragma once

#include "patchdb/TePatchIndex.h"

#include <cstdint>
#include <memory>
#include <vector>

/// The growing quadtree (document 002, the patch database): an index from integer cells of one level to the
/// patches stored there, which it owns.
///
/// The tree has an alignment of its own, origin + span, which comes from the order of requests and says
/// nothing about the ancestry of keys: the first cell stored is the root; a request outside doubles the
/// root's side, and per axis it grows toward the request if that lies outside on this axis, else in the
/// positive direction, until the cell is inside.
///
/// insert and remove cost O(depth), depth = log2(span) <= 49 for cells within ±2^47; find costs the same for
/// any number of patches (TePatchIndex). An inner node takes 16 bytes; one without leaves is freed at once.
class TeGrowingTree {
public:
  /// Cells x .. x + span - 1, y .. y + span - 1; span 0 = an empty tree.
  struct Bounds {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t span = 0;

    bool contains(std::int64_t cellX, std::int64_t cellY) const {
      const auto inside = [this](std::int64_t cell, std::int64_t first) {
        return std::uint64_t(cell) - std::uint64_t(first) < std::uint64_t(span);
      };
      return inside(cellX, x) && inside(cellY, y);
    }
    /// Quarter 0 = south-west, 1 = south-east, 2 = north-west, 3 = north-east.
    Bounds quarter(int index) const {
      return {x + (index % 2) * (span / 2), y + (index / 2) * (span / 2), span / 2};
    }
  };

  TeGrowingTree();
  ~TeGrowingTree();
  TeGrowingTree(TeGrowingTree&&) noexcept;
  TeGrowingTree& operator=(TeGrowingTree&&) noexcept;

  Bounds bounds() const { return m_bounds; }
  std::size_t size() const { return m_size; }
  /// Inner nodes in use.
  std::size_t nodes() const { return m_nodes.size() - m_freeNodes.size(); }
  std::size_t bytes() const;

  /// Null if nothing is stored there.
  TePatchData* find(std::int64_t x, std::int64_t y) const { return m_index.find(x, y); }
  /// Stores a patch in the cell of its key, which must be free and within ±2^47. If memory runs out it throws
  /// and is as before.
  TePatchData& insert(std::int64_t x, std::int64_t y, std::unique_ptr<TePatchData> patch);
  /// Takes a patch out; null if nothing is stored there. The bounds stay as they are until the last is gone.
  std::unique_ptr<TePatchData> remove(std::int64_t x, std::int64_t y);

  /// Visits all patches below the nodes that `enter(bounds)` accepts, the children of a node in the order
  /// that `enter` ranks them: it returns a double, lower first, negative = skip. `visit(patch)` returns
  /// false to stop. Returns false if it was stopped.
  template <class Enter, class Visit> bool traverse(const Enter& enter, const Visit& visit) const {
    return m_root == kNone || enter(m_bounds) < 0 || traverse(m_root, m_bounds, enter, visit);
  }

private:
  static constexpr std::int32_t kNone = -1;
  /// Children are nodes, or leaves where the children's span is 1.
  struct Node {
    std::int32_t child[4] = {kNone, kNone, kNone, kNone};
  };

  /// Up to 50 new roots, and as many nodes from there down.
  static constexpr std::size_t kMostNewNodes = 100;
  void reserve();
  void grow(std::int64_t x, std::int64_t y);
  std::int32_t newNode();
  std::int32_t newLeaf(std::unique_ptr<TePatchData> patch);
  static int quarterOf(const Bounds& bounds, std::int64_t x, std::int64_t y) {
    const std::int64_t half = bounds.span / 2;
    return (x - bounds.x >= half ? 1 : 0) + (y - bounds.y >= half ? 2 : 0);
  }

  template <class Enter, class Visit>
  bool traverse(std::int32_t index, const Bounds& bounds, const Enter& enter, const Visit& visit) const {
    if (bounds.span == 1)
      return visit(*m_leaves[std::size_t(index)]);
    const Node& node = m_nodes[std::size_t(index)];
    int order[4];
    double rank[4];
    int count = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
      if (node.child[quarter] == kNone)
        continue;
      const double r = enter(bounds.quarter(quarter));
      if (r < 0)
        continue;
      int at = count++;
      for (; at > 0 && rank[at - 1] > r; --at) {
        rank[at] = rank[at - 1];
        order[at] = order[at - 1];
      }
      rank[at] = r;
      order[at] = quarter;
    }
    for (int i = 0; i < count; ++i)
      if (!traverse(node.child[order[i]], bounds.quarter(order[i]), enter, visit))
        return false;
    return true;
  }

  Bounds m_bounds;
  std::int32_t m_root = kNone;
  std::size_t m_size = 0;
  std::vector<Node> m_nodes;
  std::vector<std::int32_t> m_freeNodes;
  std::vector<std::unique_ptr<TePatchData>> m_leaves;
  std::vector<std::int32_t> m_freeLeaves;
  TePatchIndex m_index;
};
