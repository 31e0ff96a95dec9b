#include "nodes/lod/chunked/TeChunkedLod.h"

#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>

/// What is asked of a selection.
struct TeChunkedLod::Wish {
  const TeLodView& view;
  double pixels; ///< wanted, or the dial's
  bool byDial;
  bool geomorph;
};

namespace {

constexpr int kMaxLeafCells = 256;

} // namespace

TeResult<std::unique_ptr<TeLodMethod>> TeChunkedLod::create(TeLodFieldPtr field, const Settings& settings) {
  const int cells = settings.leafCells;
  if (cells < 2 || cells > kMaxLeafCells || (cells & (cells - 1)) != 0)
    return TeError{
        teFormat("chunks of %d cells a side: not a power of two from 2 to %d", cells, kMaxLeafCells)};
  if (!std::isfinite(settings.firstError))
    return TeError{"the error of chunks is not finite"};
  const int leafCells = std::min(cells, field->cells());
  const float firstError = float(settings.firstError);
  return std::unique_ptr<TeLodMethod>(new TeChunkedLod(std::move(field), leafCells, firstError));
}

TeChunkedLod::TeChunkedLod(TeLodFieldPtr shared, int leafCells, float firstError)
    : TeLodMethod(shared), m_tree(std::move(shared), leafCells, firstError),
      m_states(m_tree.chunkCount(), State::Unseen), m_mesh(m_tree) {}

const TeLodDial& TeChunkedLod::dial() const {
  static const TeLodDial tau{"pixels", false, 1e-6, 1e6};
  return tau;
}

double TeChunkedLod::bytesPerSample() const {
  const std::size_t bytes = m_tree.bytes() + m_mesh.bytes() + m_states.capacity() * sizeof(State) +
                            m_touched.capacity() * sizeof(std::size_t) + m_drawn.capacity() * sizeof(Drawn) +
                            selection().parts.capacity() * sizeof(TeLodPart);
  return sizeof(float) + double(bytes) / (double(field().cells() + 1) * double(field().cells() + 1));
}

void TeChunkedLod::choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance&,
                          TeLodSelection& selection) {
  for (const std::size_t number : m_touched)
    m_states[number] = State::Unseen;
  m_touched.clear();
  m_drawn.clear();
  m_canCoarsen = false;
  const bool byDial = accuracy.dial > 0;
  const Wish wish{view, byDial ? accuracy.dial : accuracy.pixelError, byDial, accuracy.geomorph};
  visit(wish, m_tree.levels() - 1, 0, 0, TeLodBox::allPlanes(view), 0, selection);

  double bound = 0;
  for (Drawn& drawn : m_drawn) {
    for (int side = 0; side < TeChunkTree::kSides; side++)
      drawn.part.beyond[std::size_t(side)] = beyond(drawn.part, side);
    const std::int64_t triangles = m_mesh.triangles(drawn.part);
    selection.parts.push_back({drawn.part.key(), triangles});
    selection.triangles += triangles;
    bound = std::max(bound, view.pixels(m_mesh.error(drawn.part) * field().heightScale(), drawn.distance));
  }
  selection.errorBound = bound;
  selection.dial = wish.pixels;
}

void TeChunkedLod::visit(const Wish& wish, int level, int x, int y, unsigned planes, double largestOfParent,
                         TeLodSelection& selection) {
  const TeLodBox box = m_tree.box(level, x, y);
  selection.visited++;
  if (!box.isSeen(wish.view, planes)) {
    selection.culled++;
    return;
  }
  const double distance = box.distance(wish.view);
  const double largest = teLargestDeviation(wish.view, wish.pixels, distance, field().heightScale());
  const std::size_t number = m_tree.number(level, x, y);
  m_touched.push_back(number);
  const double error =
      wish.byDial ? double(m_tree.levelError(level)) : double(m_tree.chunk(level, x, y).error);
  if (level > 0 && (wish.pixels == 0 || error > largest)) {
    m_states[number] = State::Divided;
    m_canCoarsen = true;
    for (const int child : {0, 1, 2, 3})
      visit(wish, level - 1, 2 * x + child % 2, 2 * y + child / 2, planes, largest, selection);
    return;
  }
  m_states[number] = State::Drawn;
  Drawn drawn;
  drawn.part.level = level;
  drawn.part.x = x;
  drawn.part.y = y;
  drawn.part.morphing = wish.geomorph;
  if (wish.geomorph && level + 1 < m_tree.levels())
    drawn.part.weight = weight(level, x, y, largestOfParent);
  drawn.distance = distance;
  m_drawn.push_back(drawn);
}

// The least weight by which the chunk, were it as near as its parent, would be within the wanted error: 0
// where the parent still was, 1 where the chunk is divided.
int TeChunkedLod::weight(int level, int x, int y, double largestOfParent) const {
  const double own = double(m_tree.chunk(level, x, y).error);
  const double parents = double(m_tree.chunk(level + 1, x / 2, y / 2).error);
  const double largest = largestOfParent - m_mesh.rounding();
  if (!(own < parents) || own >= largest)
    return TeChunkPart::kWhole;
  const double share = (parents - largest) / (parents - own);
  return int(std::ceil(TeChunkPart::kWhole * std::clamp(share, 0.0, 1.0)));
}

int TeChunkedLod::beyond(const TeChunkPart& part, int side) const {
  int x = part.x + (side == 1) - (side == 3), y = part.y + (side == 2) - (side == 0);
  if (x < 0 || y < 0 || x >= m_tree.chunks(part.level) || y >= m_tree.chunks(part.level))
    return TeChunkPart::Nothing;
  switch (m_states[m_tree.number(part.level, x, y)]) {
  case State::Drawn:
    return part.morphing ? TeChunkPart::Equal : TeChunkPart::Nothing;
  case State::Divided:
    return TeChunkPart::Finer;
  case State::Unseen:
    break;
  }
  for (int level = part.level + 1; level < m_tree.levels(); level++) {
    x /= 2;
    y /= 2;
    const State state = m_states[m_tree.number(level, x, y)];
    if (state == State::Drawn)
      return TeChunkPart::Coarser + level - part.level - 1;
    if (state == State::Divided)
      break;
  }
  return TeChunkPart::Hidden;
}

void TeChunkedLod::appendPart(std::size_t part, TeLodMesh& mesh) const {
  m_mesh.append(TeChunkPart::of(selection().parts[part].key), mesh);
}
