#include "nodes/lod/rtin/TeRtinLod.h"

#include "nodes/lod/TeMeshBudget.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace {

constexpr std::uint64_t kCulled = 0;
constexpr std::uint64_t kWhole = 1;
constexpr std::uint64_t kHalved = 2;

/// Fewer triangles are always counted to the end, so that there is a mesh even with a budget of one.
constexpr std::int64_t kLeastBudget = 4096;
constexpr std::int64_t kGivenUp = 4;    ///< times the budget
constexpr double kExactStep = 1.0 / 64; ///< pixels, where an exact selection has to be lowered

/// The finalizer of MurmurHash3 (Appleby 2011).
std::uint64_t mixed(std::uint64_t bits) {
  bits ^= bits >> 33;
  bits *= 0xff51afd7ed558ccd;
  bits ^= bits >> 33;
  bits *= 0xc4ceb9fe1a85ec53;
  return bits ^ bits >> 33;
}

} // namespace

void TeRtinLod::Code::add(std::uint64_t two) {
  const bool isFull = bits >> 62 != 0;
  bits = bits << 2 | two;
  if (isFull) {
    hash = mixed(hash ^ bits) + bits;
    bits = 1;
  }
}

std::uint64_t TeRtinLod::Code::finish() {
  hash = mixed(hash ^ bits);
  return hash;
}

TeRtinLod::TeRtinLod(TeLodFieldPtr shared, TeRtinError error)
    : TeLodMethod(std::move(shared)), m_cells(field().cells()), m_error(error),
      m_errors(TeRtinErrors::create(field().heights(), error)), m_ranges(field().heights()),
      m_marks((m_errors.size() + 63) / 64) {
  const std::size_t side = std::size_t(std::max(1, m_cells >> kPartsLog)) + 1;
  m_numbers.resize(side * side);
}

std::string TeRtinLod::name() const { return m_error == TeRtinError::Exact ? "rtin" : "rtin-midpoint"; }

const TeLodDial& TeRtinLod::dial() const {
  static const TeLodDial metres{"metres", false, 1e-6, 1e6};
  return metres;
}

double TeRtinLod::bytesPerSample() const {
  const std::size_t bytes = m_errors.size() * sizeof(float) + m_ranges.bytes() + m_marks.size() * 8 +
                            m_marked.capacity() * sizeof(std::uint32_t) +
                            m_corners.capacity() * sizeof(std::uint32_t) +
                            m_numbers.size() * sizeof(std::uint32_t) + m_parts.capacity() * sizeof(Part);
  return sizeof(float) + double(bytes) / double(m_errors.size());
}

void TeRtinLod::clearMarks() {
  for (const std::uint32_t index : m_marked)
    m_marks[index / 64] = 0;
  m_marked.clear();
  for (const Corner& corner : {Corner{0, 0}, {m_cells, 0}, {0, m_cells}, {m_cells, m_cells}})
    m_marks[indexOf(corner) / 64] |= std::uint64_t(1) << (indexOf(corner) % 64);
}

void TeRtinLod::mark(const Corner& vertex) {
  const std::size_t index = indexOf(vertex);
  if (isMarked(index))
    return;
  m_marks[index / 64] |= std::uint64_t(1) << (index % 64);
  m_marked.push_back(std::uint32_t(index));
  const TeRtinTriangle::Needed needed = TeRtinTriangle::neededFor(vertex, m_cells);
  mark(needed.first);
  mark(needed.second);
}

void TeRtinLod::markWhatIsNeeded(TeRtinTest& test, const TeRtinTriangle& triangle, std::uint32_t planes,
                                 double distance, TeLodSelection& selection) {
  if (m_terminals > m_most)
    return;
  selection.visited++;
  // Errors are at least those of dependent vertices, and their boxes lie in this one: what is fine needs
  // nothing below, either, also if its neighbour halves it.
  if (triangle.isSmallest()) {
    m_terminals++;
    return;
  }
  const Corner middle = triangle.middle();
  const float error = m_errors[indexOf(middle)];
  if (test.isFineAnyway(error, distance)) { // at the distance of the box around this one's
    m_terminals++;
    return;
  }
  const TeRtinTest::Box box = test.box(triangle);
  if (!test.isSeen(box, planes)) {
    selection.culled++;
    return;
  }
  const double own = test.distanceTo(box);
  if (test.isFine(error, own)) {
    m_terminals++;
    return;
  }
  mark(middle);
  markWhatIsNeeded(test, triangle.firstHalf(), planes, own, selection);
  markWhatIsNeeded(test, triangle.secondHalf(), planes, own, selection);
}

void TeRtinLod::emit(const TeRtinTest& test, const TeRtinTriangle& triangle, std::uint32_t planes) {
  if (planes != 0 && !test.isSeen(test.box(triangle), planes)) {
    m_code.add(kCulled);
    return;
  }
  if (triangle.isSmallest() || !isMarked(indexOf(triangle.middle()))) {
    m_code.add(kWhole);
    for (const Corner& corner : {triangle.a(), triangle.b(), triangle.apex()})
      m_corners.push_back(std::uint32_t(indexOf(corner)));
    return;
  }
  m_code.add(kHalved);
  emit(test, triangle.firstHalf(), planes);
  emit(test, triangle.secondHalf(), planes);
}

void TeRtinLod::emitParts(const TeRtinTest& test, const TeRtinTriangle& triangle, std::uint32_t planes,
                          std::uint64_t number, TeLodSelection& selection) {
  const bool isPart = triangle.isHalfSquare() && 1 << triangle.sizeLog() <= std::max(1, m_cells >> kPartsLog);
  if (!isPart && !triangle.isSmallest() && isMarked(indexOf(triangle.middle()))) {
    if (planes != 0 && !test.isSeen(test.box(triangle), planes))
      return;
    emitParts(test, triangle.firstHalf(), planes, 2 * number, selection);
    emitParts(test, triangle.secondHalf(), planes, 2 * number + 1, selection);
    return;
  }
  const std::size_t first = m_corners.size();
  m_code = Code{mixed(number), 1};
  emit(test, triangle, planes);
  const std::size_t count = (m_corners.size() - first) / 3;
  if (count == 0)
    return;
  m_parts.push_back({first, count, {triangle.lowColumn(), triangle.lowRow()}});
  selection.parts.push_back({m_code.finish(), std::int64_t(count)});
  selection.triangles += std::int64_t(count);
}

std::int64_t TeRtinLod::make(TeRtinTest& test, TeLodSelection& selection) {
  selection.parts.clear();
  selection.triangles = selection.visited = selection.culled = 0;
  m_terminals = 0;
  m_corners.clear();
  m_parts.clear();
  clearMarks();
  const TeRtinTriangle halves[] = {TeRtinTriangle::root(field().cellsLog(), 0),
                                   TeRtinTriangle::root(field().cellsLog(), 1)};
  for (const TeRtinTriangle& half : halves)
    markWhatIsNeeded(test, half, test.allPlanes(), 0, selection);
  if (m_terminals > m_most)
    return m_terminals;
  emitParts(test, halves[0], test.allPlanes(), 2, selection);
  emitParts(test, halves[1], test.allPlanes(), 3, selection);
  return selection.triangles;
}

void TeRtinLod::choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance&,
                       TeLodSelection& selection) {
  const bool usesDial = accuracy.dial > 0;
  const double first = usesDial ? accuracy.dial : std::max(accuracy.pixelError, kExactStep);
  m_most = std::max(kGivenUp * accuracy.maxTriangles, kLeastBudget);
  const auto triangles = [&](double coarsening) {
    TeLodAccuracy tried = accuracy;
    if (coarsening > 1)
      (usesDial ? tried.dial : tried.pixelError) = first * coarsening;
    TeRtinTest test(field(), m_ranges, view, tried);
    const std::int64_t made = make(test, selection);
    selection.errorBound = test.isExact()                  ? 0
                           : m_error == TeRtinError::Exact ? test.worst()
                                                           : std::numeric_limits<double>::infinity();
    selection.dial = usesDial ? tried.dial : test.worstMetres();
    return made;
  };
  const double last = m_acceptedDial == usesDial ? m_accepted / first : 0;
  selection.coarsening =
      TeMeshBudget::search(accuracy.maxTriangles, std::max(1.0, last), std::cref(triangles));
  m_accepted = selection.coarsening > 1 ? first * selection.coarsening : 0;
  m_acceptedDial = usesDial;
}

void TeRtinLod::appendPart(std::size_t number, TeLodMesh& mesh) const {
  const Part& part = m_parts[number];
  const std::size_t width = std::size_t(m_cells) + 1;
  const std::size_t side = std::size_t(std::max(1, m_cells >> kPartsLog)) + 1;
  const std::size_t firstVertex = mesh.vertices.size();
  const std::size_t firstIndex = mesh.indices.size();
  mesh.indices.resize(firstIndex + 3 * part.count);
  const std::uint32_t* corners = m_corners.data() + part.first;
  if (part.count == 1) { // perhaps larger than the squares of parts
    for (std::size_t i = 0; i < 3; i++) {
      mesh.indices[firstIndex + i] = std::uint32_t(mesh.vertices.size());
      mesh.vertices.push_back(field().vertex(int(corners[i] % width), int(corners[i] / width)));
    }
    return;
  }
  for (std::size_t i = 0; i < 3 * part.count; i++) {
    const std::int32_t column = std::int32_t(corners[i] % width), row = std::int32_t(corners[i] / width);
    std::uint32_t& known =
        m_numbers[std::size_t(row - part.low.row) * side + std::size_t(column - part.low.column)];
    if (known == 0) {
      mesh.vertices.push_back(field().vertex(column, row));
      known = std::uint32_t(mesh.vertices.size() - firstVertex);
    }
    mesh.indices[firstIndex + i] = std::uint32_t(firstVertex) + known - 1;
  }
  for (std::size_t i = firstVertex; i < mesh.vertices.size(); i++) {
    const TeLodVertex& vertex = mesh.vertices[i];
    m_numbers[std::size_t(vertex.row - part.low.row) * side + std::size_t(vertex.column - part.low.column)] =
        0;
  }
}
