#include "patchdb/TeGrowingTree.h"

#include "patchdb/TePatchData.h"

#include <algorithm>
#include <cassert>

TeGrowingTree::TeGrowingTree() = default;
TeGrowingTree::~TeGrowingTree() = default;
TeGrowingTree::TeGrowingTree(TeGrowingTree&&) noexcept = default;
TeGrowingTree& TeGrowingTree::operator=(TeGrowingTree&&) noexcept = default;

std::size_t TeGrowingTree::bytes() const {
  return m_nodes.capacity() * sizeof(Node) + m_leaves.capacity() * sizeof(m_leaves[0]) +
         (m_freeNodes.capacity() + m_freeLeaves.capacity()) * sizeof(std::int32_t) + m_index.bytes();
}

TePatchData& TeGrowingTree::insert(std::int64_t x, std::int64_t y, std::unique_ptr<TePatchData> patch) {
  assert(patch && patch->key().x == x && patch->key().y == y && !find(x, y));
  TePatchData& stored = *patch;
  reserve();
  m_index.add(stored);
  const std::int32_t leaf = newLeaf(std::move(patch));
  ++m_size;
  if (m_root == kNone) {
    m_bounds = {x, y, 1};
    m_root = leaf;
    return stored;
  }
  while (!m_bounds.contains(x, y))
    grow(x, y);
  Bounds bounds = m_bounds;
  std::int32_t node = m_root;
  while (bounds.span > 2) {
    const int quarter = quarterOf(bounds, x, y);
    std::int32_t next = m_nodes[std::size_t(node)].child[quarter];
    if (next == kNone) {
      next = newNode();
      m_nodes[std::size_t(node)].child[quarter] = next;
    }
    node = next;
    bounds = bounds.quarter(quarter);
  }
  m_nodes[std::size_t(node)].child[quarterOf(bounds, x, y)] = leaf;
  return stored;
}

/// Room for one more patch and its way to the root, and to note all as free again, so that nothing but this
/// can fail for want of memory.
void TeGrowingTree::reserve() {
  const auto makeRoom = [](auto& elements, std::size_t atLeast) {
    if (elements.capacity() < atLeast)
      elements.reserve(std::max(atLeast, 2 * elements.capacity()));
  };
  makeRoom(m_nodes, m_nodes.size() + kMostNewNodes);
  makeRoom(m_freeNodes, m_nodes.capacity());
  makeRoom(m_leaves, m_leaves.size() + 1);
  makeRoom(m_freeLeaves, m_leaves.capacity());
  m_index.reserve(m_size + 1);
}

void TeGrowingTree::grow(std::int64_t x, std::int64_t y) {
  const bool west = x < m_bounds.x;
  const bool south = y < m_bounds.y;
  const std::int32_t root = newNode();
  m_nodes[std::size_t(root)].child[(west ? 1 : 0) + (south ? 2 : 0)] = m_root;
  m_root = root;
  if (west)
    m_bounds.x -= m_bounds.span;
  if (south)
    m_bounds.y -= m_bounds.span;
  m_bounds.span *= 2;
}

std::unique_ptr<TePatchData> TeGrowingTree::remove(std::int64_t x, std::int64_t y) {
  if (!find(x, y))
    return nullptr;
  std::int32_t path[64];
  int quarters[64];
  int depth = 0;
  Bounds bounds = m_bounds;
  std::int32_t index = m_root;
  for (; bounds.span > 1; ++depth) {
    path[depth] = index;
    quarters[depth] = quarterOf(bounds, x, y);
    index = m_nodes[std::size_t(index)].child[quarters[depth]];
    bounds = bounds.quarter(quarters[depth]);
  }
  std::unique_ptr<TePatchData> patch = std::move(m_leaves[std::size_t(index)]);
  m_freeLeaves.push_back(index);
  m_index.remove(*patch);
  --m_size;
  while (depth > 0) {
    --depth;
    Node& node = m_nodes[std::size_t(path[depth])];
    node.child[quarters[depth]] = kNone;
    for (std::int32_t child : node.child)
      if (child != kNone)
        return patch;
    m_freeNodes.push_back(path[depth]);
  }
  *this = TeGrowingTree();
  return patch;
}

std::int32_t TeGrowingTree::newNode() {
  if (m_freeNodes.empty()) {
    m_nodes.emplace_back();
    return std::int32_t(m_nodes.size() - 1);
  }
  const std::int32_t index = m_freeNodes.back();
  m_freeNodes.pop_back();
  m_nodes[std::size_t(index)] = Node();
  return index;
}

std::int32_t TeGrowingTree::newLeaf(std::unique_ptr<TePatchData> patch) {
  if (m_freeLeaves.empty()) {
    m_leaves.push_back(std::move(patch));
    return std::int32_t(m_leaves.size() - 1);
  }
  const std::int32_t index = m_freeLeaves.back();
  m_freeLeaves.pop_back();
  m_leaves[std::size_t(index)] = std::move(patch);
  return index;
}
