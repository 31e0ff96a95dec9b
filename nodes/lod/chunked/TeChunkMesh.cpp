#include "nodes/lod/chunked/TeChunkMesh.h"

#include "nodes/lod/chunked/TeChunkTriangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// Of a skirt, in distances of samples.
constexpr double kLeastDepth = 1.0 / 64;
constexpr std::uint64_t kEmpty = ~std::uint64_t(0);

std::uint64_t placeOf(int column, int row) { return std::uint64_t(row) << 15 | std::uint64_t(column); }

} // namespace

TeChunkMesh::TeChunkMesh(const TeChunkTree& tree)
    : m_tree(tree), m_largestHeight(std::max(std::fabs(double(tree.field().lowest())),
                                             std::fabs(double(tree.field().highest())))) {
  const TeLodField& field = tree.field();
  if (field.heightScale() > 0)
    m_leastDepth = kLeastDepth * field.spacing() / field.heightScale();
}

std::size_t TeChunkMesh::bytes() const {
  return m_table.capacity() * sizeof(Slot) + m_parents.capacity() * sizeof(double);
}

double TeChunkMesh::parentError(const TeChunkPart& part) const {
  return part.level + 1 < m_tree.levels() ? double(m_tree.chunk(part.level + 1, part.x / 2, part.y / 2).error)
                                          : 0;
}

double TeChunkMesh::error(const TeChunkPart& part) const {
  const double own = double(m_tree.chunk(part.level, part.x, part.y).error);
  if (part.weight == TeChunkPart::kWhole)
    return own;
  const double share = double(part.weight) / TeChunkPart::kWhole;
  return share * own + (1 - share) * parentError(part) + rounding();
}

double TeChunkMesh::borderError(const TeChunkPart& part, int side) const {
  const double own = double(m_tree.chunk(part.level, part.x, part.y).borderErrors[std::size_t(side)]);
  return part.weight == TeChunkPart::kWhole ? own : std::max(own, parentError(part));
}

float TeChunkMesh::skirtDepth(const TeChunkPart& part, int side) const {
  const int beyond = part.beyond[std::size_t(side)];
  if (beyond == TeChunkPart::Nothing)
    return 0;
  double depth = borderError(part, side);
  if (beyond == TeChunkPart::Hidden) {
    if (depth == 0)
      return 0;
  } else if (beyond == TeChunkPart::Finer) {
    depth += double(m_tree.largestError(part.morphing ? part.level : part.level - 1));
  } else {
    const int coarser = beyond == TeChunkPart::Equal ? 0 : beyond - TeChunkPart::Coarser + 1;
    TeChunkPart other;
    other.level = part.level + coarser;
    other.x = (part.x + (side == 1) - (side == 3)) >> coarser;
    other.y = (part.y + (side == 2) - (side == 0)) >> coarser;
    other.weight = part.morphing ? 0 : TeChunkPart::kWhole;
    depth += borderError(other, (side + 2) % 4);
  }
  return float(depth * (1 + 0x1p-20) + 4 * rounding() + m_leastDepth); // more than rounding takes away
}

std::int64_t TeChunkMesh::triangles(const TeChunkPart& part) const {
  const TeChunkTree::Chunk& chunk = m_tree.chunk(part.level, part.x, part.y);
  std::int64_t triangles = chunk.triangles;
  for (int side = 0; side < TeChunkTree::kSides; side++)
    if (skirtDepth(part, side) > 0)
      triangles += 2 * std::int64_t(chunk.borderEdges[std::size_t(side)]);
  return triangles;
}

double TeChunkMesh::parentAtCorner(const TeChunkPart& part, int column, int row) const {
  const TeLodField& field = m_tree.field();
  const auto height = [&](int x, int y) { return double(field.height(x, y)); };
  const int level = part.level + 1;
  if (level == m_tree.levels() || m_tree.isVertex(level, column, row))
    return height(column, row);
  const TeChunkTree::Square parent = m_tree.square(level, part.x / 2, part.y / 2);
  const int west = parent.column, south = parent.row, side = parent.cells;
  const bool middleX = column - west == side / 2, middleY = row - south == side / 2;
  if (middleX && middleY)
    return parent.rising ? 0.5 * (height(west, south) + height(west + side, south + side))
                         : 0.5 * (height(west + side, south) + height(west, south + side));
  if (middleX)
    return 0.5 * (height(west, row) + height(west + side, row));
  if (middleY)
    return 0.5 * (height(column, south) + height(column, south + side));
  return height(column, row);
}

float TeChunkMesh::morphed(float own, double parent, int weight) const {
  if (weight == TeChunkPart::kWhole)
    return own;
  return float(parent + (double(own) - parent) * (double(weight) / TeChunkPart::kWhole));
}

void TeChunkMesh::beginTable(std::size_t vertices) {
  std::size_t size = 64;
  while (size < 2 * vertices)
    size *= 2;
  m_mask = size - 1;
  if (m_table.size() < size)
    m_table.resize(size);
  std::fill(m_table.begin(), m_table.begin() + std::ptrdiff_t(size), Slot{kEmpty, 0});
}

std::pair<std::uint32_t, bool> TeChunkMesh::numberOf(std::uint64_t what, std::uint32_t next) {
  std::size_t place = std::size_t(what * 0x9E3779B97F4A7C15u >> 20) & m_mask;
  while (m_table[place].what != what) {
    if (m_table[place].what == kEmpty) {
      m_table[place] = {what, next};
      return {next, true};
    }
    place = (place + 1) & m_mask;
  }
  return {m_table[place].number, false};
}

/// Takes triangles into a mesh, with the walls at those edges that are borders.
struct TeChunkMesh::Output {
  Output(TeChunkMesh& maker, const TeChunkPart& part, TeLodMesh& mesh)
      : maker(maker), mesh(mesh), square(maker.m_tree.square(part.level, part.x, part.y)) {
    for (int side = 0; side < TeChunkTree::kSides; side++)
      depths[side] = maker.skirtDepth(part, side);
  }

  void operator()(const Corner& a, const Corner& b, const Corner& c) {
    mesh.indices.insert(mesh.indices.end(), {a.index, b.index, c.index});
    addBorder(a, b);
    addBorder(b, c);
    addBorder(c, a);
  }

  void addBorder(const Corner& from, const Corner& to) {
    int side = -1;
    if (from.row == to.row && (from.row == square.row || from.row == square.row + square.cells))
      side = from.row == square.row ? 0 : 2;
    else if (from.column == to.column &&
             (from.column == square.column || from.column == square.column + square.cells))
      side = from.column == square.column ? 3 : 1;
    if (side < 0 || !(depths[side] > 0))
      return;
    const std::uint32_t below = bottom(from, side), end = bottom(to, side);
    mesh.skirts.insert(mesh.skirts.end(), {below, end, to.index, below, to.index, from.index});
  }

  std::uint32_t bottom(const Corner& corner, int side) {
    const std::uint64_t what = std::uint64_t(side + 1) << 32 | placeOf(corner.column, corner.row);
    const auto [number, isNew] = maker.numberOf(what, std::uint32_t(mesh.vertices.size()));
    if (isNew) {
      const float lowered = mesh.vertices[corner.index].height - depths[side];
      mesh.vertices.push_back({corner.column, corner.row, lowered});
    }
    return number;
  }

  TeChunkMesh& maker;
  TeLodMesh& mesh;
  TeChunkTree::Square square;
  float depths[TeChunkTree::kSides];
};

/// Corners that are vertices of a mesh.
struct TeChunkMesh::Vertices {
  TeChunkMesh& maker;
  const TeChunkPart& part;
  TeLodMesh& mesh;

  Corner at(int column, int row) {
    return vertex(column, row,
                  part.weight == TeChunkPart::kWhole ? 0 : maker.parentAtCorner(part, column, row));
  }
  Corner middle(const Corner& a, const Corner& b, int column, int row) {
    const bool own = maker.m_tree.isVertex(part.level + 1, column, row);
    return vertex(column, row,
                  own ? double(maker.m_tree.field().height(column, row)) : 0.5 * (a.parent + b.parent));
  }
  Corner vertex(int column, int row, double parent) {
    const auto [number, isNew] = maker.numberOf(placeOf(column, row), std::uint32_t(mesh.vertices.size()));
    if (isNew)
      mesh.vertices.push_back(
          {column, row, maker.morphed(maker.m_tree.field().height(column, row), parent, part.weight)});
    return {column, row, number, parent};
  }
};

/// Keeps the height of the parent's surface at every sample of a leaf.
struct TeChunkMesh::Heights {
  TeChunkMesh& maker;
  const TeChunkPart& part;
  TeChunkTree::Square square;

  Corner at(int column, int row) { return keep(column, row, maker.parentAtCorner(part, column, row)); }
  Corner middle(const Corner& a, const Corner& b, int column, int row) {
    const bool own = maker.m_tree.isVertex(part.level + 1, column, row);
    return keep(column, row,
                own ? double(maker.m_tree.field().height(column, row)) : 0.5 * (a.parent + b.parent));
  }
  Corner keep(int column, int row, double parent) {
    const std::size_t place =
        std::size_t(row - square.row) * std::size_t(square.cells + 1) + std::size_t(column - square.column);
    maker.m_parents[place] = parent;
    return {column, row, 0, parent};
  }
};

void TeChunkMesh::append(const TeChunkPart& part, TeLodMesh& mesh) {
  const TeChunkTree::Chunk& chunk = m_tree.chunk(part.level, part.x, part.y);
  std::size_t vertices = std::size_t(chunk.triangles) / 2 + 2;
  for (const std::int32_t edges : chunk.borderEdges)
    vertices += 2 * std::size_t(edges) + 1; // on borders, and below
  beginTable(vertices);
  if (part.level == 0) {
    appendCells(part, mesh);
    return;
  }
  Vertices make{*this, part, mesh};
  Output take(*this, part, mesh);
  TeChunkTriangles<Corner, Vertices, Output>(m_tree, part.level, false, make, take).walk(part.x, part.y);
}

void TeChunkMesh::appendCells(const TeChunkPart& part, TeLodMesh& mesh) {
  const TeChunkTree::Square square = m_tree.square(part.level, part.x, part.y);
  const int width = square.cells + 1;
  if (part.weight != TeChunkPart::kWhole) {
    m_parents.resize(std::size_t(width) * std::size_t(width));
    Heights make{*this, part, square};
    const auto ignore = [](const Corner&, const Corner&, const Corner&) {};
    TeChunkTriangles<Corner, Heights, decltype(ignore)>(m_tree, part.level, true, make, ignore)
        .walk(part.x, part.y);
  }
  const auto first = std::uint32_t(mesh.vertices.size());
  for (int y = 0; y < width; y++)
    for (int x = 0; x < width; x++) {
      TeLodVertex vertex = m_tree.field().vertex(square.column + x, square.row + y);
      if (part.weight != TeChunkPart::kWhole)
        vertex.height = morphed(vertex.height, m_parents[std::size_t(y * width + x)], part.weight);
      mesh.vertices.push_back(vertex);
    }
  Output take(*this, part, mesh);
  const auto corner = [&](int x, int y) {
    return Corner{square.column + x, square.row + y, first + std::uint32_t(y * width + x), 0};
  };
  for (int y = 0; y < square.cells; y++)
    for (int x = 0; x < square.cells; x++) {
      take(corner(x, y), corner(x + 1, y), corner(x + 1, y + 1));
      take(corner(x, y), corner(x + 1, y + 1), corner(x, y + 1));
    }
}
