#include "nodes/lod/geomipmap/TeGeoMipMapping.h"

#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr std::uint8_t kNotDrawn = 255;
constexpr int kLevelBits = 4;

} // namespace

/// What is asked of a selection.
struct TeGeoMipMapping::Wish {
  const TeLodView& view;
  double pixels; ///< wanted, or the threshold of the dial
  bool byDial;
};

TeResult<std::unique_ptr<TeLodMethod>> TeGeoMipMapping::create(TeLodFieldPtr field,
                                                               const Settings& settings) {
  const int cells = settings.patchCells == 0 ? std::clamp(field->cells() / 128, 8, 32) : settings.patchCells;
  if (cells < 2 || cells > TeGeoMipPatterns::kMaxPatchCells || (cells & (cells - 1)) != 0)
    return TeError{teFormat("patches of %d cells a side: neither 0 nor a power of two from 2 to %d", cells,
                            TeGeoMipPatterns::kMaxPatchCells)};
  const int patchCells = std::min(cells, field->cells());
  return std::unique_ptr<TeLodMethod>(new TeGeoMipMapping(std::move(field), patchCells));
}

TeGeoMipMapping::TeGeoMipMapping(TeLodFieldPtr shared, int patchCells)
    : TeLodMethod(std::move(shared)), m_patterns(patchCells), m_errors(field(), m_patterns),
      m_patches(m_errors.patches()),
      m_levels(std::size_t(m_patches + 2) * std::size_t(m_patches + 2), kNotDrawn),
      m_places(m_levels.size()) {
  m_ranges.emplace_back(); // height 0: m_errors has them
  for (int side = m_patches / 2; side > 0; side /= 2) {
    std::vector<TeGeoMipErrors::Range> ranges(std::size_t(side) * std::size_t(side));
    for (int y = 0; y < side; y++)
      for (int x = 0; x < side; x++) {
        TeGeoMipErrors::Range range{field().highest(), field().lowest()};
        for (const int child : {0, 1, 2, 3}) {
          const int cx = 2 * x + child % 2, cy = 2 * y + child / 2;
          const TeGeoMipErrors::Range& part = m_ranges.size() == 1
                                                  ? m_errors.range(cx, cy)
                                                  : m_ranges.back()[std::size_t(cy * side * 2 + cx)];
          range.low = std::min(range.low, part.low);
          range.high = std::max(range.high, part.high);
        }
        ranges[std::size_t(y * side + x)] = range;
      }
    m_ranges.push_back(std::move(ranges));
  }
}

const TeLodDial& TeGeoMipMapping::dial() const {
  static const TeLodDial threshold{"pixels", false, 1e-6, 1e6};
  return threshold;
}

double TeGeoMipMapping::bytesPerSample() const {
  std::size_t bytes = m_errors.bytes() + m_levels.capacity() + m_places.capacity() * sizeof(std::uint32_t) +
                      m_drawn.capacity() * sizeof(Drawn) + m_pending.capacity() * sizeof(std::uint32_t) +
                      selection().parts.capacity() * sizeof(TeLodPart);
  for (const auto& ranges : m_ranges)
    bytes += ranges.capacity() * sizeof(TeGeoMipErrors::Range);
  return sizeof(float) + double(bytes) / (double(field().cells() + 1) * double(field().cells() + 1));
}

TeLodBox TeGeoMipMapping::box(int height, int x, int y) const {
  const int cells = m_patterns.patchCells() << height;
  const TeGeoMipErrors::Range& range =
      height == 0 ? m_errors.range(x, y)
                  : m_ranges[std::size_t(height)][std::size_t(y * (m_patches >> height) + x)];
  return {field().position(x * cells, y * cells, double(range.low)),
          field().position((x + 1) * cells, (y + 1) * cells, double(range.high))};
}

void TeGeoMipMapping::choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance&,
                             TeLodSelection& selection) {
  for (const Drawn& drawn : m_drawn)
    m_levels[cell(drawn.x, drawn.y)] = kNotDrawn;
  m_drawn.clear();
  m_canCoarsen = false;
  const bool byDial = accuracy.dial > 0;
  const Wish wish{view, byDial ? accuracy.dial : accuracy.pixelError, byDial};
  visit(wish, int(m_ranges.size()) - 1, 0, 0, TeLodBox::allPlanes(view), selection);
  if (!byDial)
    refineNeighbours();
  report(wish, selection);
}

void TeGeoMipMapping::visit(const Wish& wish, int height, int x, int y, unsigned planes,
                            TeLodSelection& selection) {
  const TeLodBox box = this->box(height, x, y);
  selection.visited++;
  if (!box.isSeen(wish.view, planes)) {
    selection.culled++;
    return;
  }
  if (height == 0) {
    draw(wish, x, y, box);
    return;
  }
  for (const int child : {0, 1, 2, 3})
    visit(wish, height - 1, 2 * x + child % 2, 2 * y + child / 2, planes, selection);
}

void TeGeoMipMapping::draw(const Wish& wish, int x, int y, const TeLodBox& box) {
  const double distance = box.distance(wish.view);
  const TeGeoMipErrors::Patch errors = m_errors.patch(x, y);
  int level = m_patterns.levels() - 1;
  double largest = 0;
  if (wish.byDial) {
    const double middle = glm::length(0.5 * (box.low + box.high) - wish.view.eye);
    largest = teLargestDeviation(wish.view, wish.pixels, middle, field().heightScale());
    while (level > 0 && double(errors.midpoint(level)) > largest)
      level--;
  } else if (wish.pixels > 0) {
    largest = teLargestDeviation(wish.view, wish.pixels, distance, field().heightScale());
    while (level > 0 && double(errors.regular(level)) > largest)
      level--;
  } else {
    level = 0;
  }
  const std::size_t cell = this->cell(x, y);
  m_levels[cell] = std::uint8_t(level);
  m_places[cell] = std::uint32_t(m_drawn.size());
  m_drawn.push_back({x, y, distance, largest});
}

void TeGeoMipMapping::refineNeighbours() {
  m_pending.resize(m_drawn.size());
  for (std::size_t i = 0; i < m_pending.size(); i++)
    m_pending[i] = std::uint32_t(m_pending.size() - 1 - i);
  // Levels only fall, so this ends; errors rise with the border's level, so a border that was good enough
  // remains so when the neighbour falls further.
  while (!m_pending.empty()) {
    const Drawn& drawn = m_drawn[m_pending.back()];
    m_pending.pop_back();
    const std::size_t here = cell(drawn.x, drawn.y);
    const int level = m_levels[here];
    const TeGeoMipErrors::Patch errors = m_errors.patch(drawn.x, drawn.y);
    for (int side = 0; side < 4; side++) {
      const std::size_t there = beside(here, side);
      int border = m_levels[there];
      if (border == kNotDrawn || border <= level)
        continue;
      while (double(errors.stitched(level, TeGeoMipSide(side), border)) > drawn.largest)
        border--;
      if (border == m_levels[there])
        continue;
      m_levels[there] = std::uint8_t(border);
      m_pending.push_back(m_places[there]);
    }
  }
}

void TeGeoMipMapping::report(const Wish& wish, TeLodSelection& selection) {
  double bound = 0;
  for (const Drawn& drawn : m_drawn) {
    const std::size_t here = cell(drawn.x, drawn.y);
    const int level = m_levels[here];
    const TeGeoMipErrors::Patch errors = m_errors.patch(drawn.x, drawn.y);
    float error = errors.regular(level);
    TeGeoMipSides sides;
    for (int side = 0; side < 4; side++) {
      // What is not drawn has no border in view.
      const int other = m_levels[beside(here, side)];
      const int border = other == kNotDrawn ? level : std::max(level, other);
      sides[std::size_t(side)] = border;
      error = std::max(error, errors.stitched(level, TeGeoMipSide(side), border));
    }
    const std::int64_t triangles = m_patterns.triangles(level, sides);
    selection.parts.push_back({keyOf(drawn, level, sides), triangles});
    selection.triangles += triangles;
    bound = std::max(bound, wish.view.pixels(double(error) * field().heightScale(), drawn.distance));
    m_canCoarsen = m_canCoarsen || level + 1 < m_patterns.levels();
  }
  selection.errorBound = bound;
  selection.dial = wish.pixels;
}

std::uint64_t TeGeoMipMapping::keyOf(const Drawn& drawn, int level, const TeGeoMipSides& sides) const {
  std::uint64_t key = std::uint64_t(drawn.y) * std::uint64_t(m_patches) + std::uint64_t(drawn.x);
  key = key << kLevelBits | std::uint64_t(level);
  for (const int side : sides)
    key = key << kLevelBits | std::uint64_t(side);
  return key;
}

TeGeoMipMapping::Part TeGeoMipMapping::partOf(std::uint64_t key) const {
  constexpr std::uint64_t kMask = (1u << kLevelBits) - 1;
  Part part;
  for (std::size_t side = 4; side-- > 0; key >>= kLevelBits)
    part.sides[side] = int(key & kMask);
  part.level = int(key & kMask);
  key >>= kLevelBits;
  part.x = int(key % std::uint64_t(m_patches));
  part.y = int(key / std::uint64_t(m_patches));
  return part;
}

void TeGeoMipMapping::appendPart(std::size_t number, TeLodMesh& mesh) const {
  const Part part = partOf(selection().parts[number].key);
  const auto first = std::uint32_t(mesh.vertices.size());
  const int cells = m_patterns.cells(part.level);
  const int column = part.x * m_patterns.patchCells(), row = part.y * m_patterns.patchCells();
  for (int y = 0; y <= cells; y++)
    for (int x = 0; x <= cells; x++)
      mesh.vertices.push_back(field().vertex(column + (x << part.level), row + (y << part.level)));
  m_patterns.append(part.level, part.sides, first, mesh.indices);
}
