#include "nodes/lod/geomipmap/TeGeoMipMapping.h"

#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr std::uint8_t kNotDrawn = 255;
constexpr int kWhole = TeGeoMipPart::kWhole;
constexpr int kMaxPatches = 4096; ///< a side: what keys have room for

/// Errors from which on a level is used where vertices morph, `before` being that of the next finer one:
/// there all vertices may stand on its surface without being off by more.
double morphError(const TeGeoMipErrors::Patch& errors, int level, bool byDial, double before) {
  if (byDial)
    return double(errors.midpoint(level));
  const double moved = double(errors.regular(level - 1)) + double(errors.midpoint(level));
  return std::max({before, double(errors.regular(level)), moved});
}

} // namespace

/// What is asked of a selection.
struct TeGeoMipMapping::Wish {
  const TeLodView& view;
  double pixels; ///< wanted, or the threshold of the dial
  bool byDial;
  bool geomorph;
};

TeResult<std::unique_ptr<TeLodMethod>> TeGeoMipMapping::create(TeLodFieldPtr field,
                                                               const Settings& settings) {
  const int cells = settings.patchCells == 0 ? std::clamp(field->cells() / 128, 8, 32) : settings.patchCells;
  if (cells < 2 || cells > TeGeoMipPatterns::kMaxPatchCells || (cells & (cells - 1)) != 0)
    return TeError{teFormat("patches of %d cells a side: neither 0 nor a power of two from 2 to %d", cells,
                            TeGeoMipPatterns::kMaxPatchCells)};
  const int patchCells = std::min(cells, field->cells());
  if (field->cells() / patchCells > kMaxPatches)
    return TeError{teFormat("%d patches a side: more than %d", field->cells() / patchCells, kMaxPatches)};
  return std::unique_ptr<TeLodMethod>(new TeGeoMipMapping(std::move(field), patchCells));
}

TeGeoMipMapping::TeGeoMipMapping(TeLodFieldPtr shared, int patchCells)
    : TeLodMethod(std::move(shared)), m_patterns(patchCells), m_errors(field(), m_patterns),
      m_mesh(field(), m_patterns, m_errors), m_patches(m_errors.patches()),
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
  const Wish wish{view, byDial ? accuracy.dial : accuracy.pixelError, byDial,
                  accuracy.geomorph && (byDial || accuracy.pixelError > 0)};
  visit(wish, int(m_ranges.size()) - 1, 0, 0, TeLodBox::allPlanes(view), selection);
  if (!byDial)
    refineNeighbours();
  if (wish.geomorph) {
    weigh(wish);
    if (!byDial)
      raiseWeights();
  }
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
  if (wish.byDial || wish.pixels > 0) {
    const double middle = glm::length(0.5 * (box.low + box.high) - wish.view.eye);
    largest =
        teLargestDeviation(wish.view, wish.pixels, wish.byDial ? middle : distance, field().heightScale());
    if (wish.geomorph) {
      largest = std::max(0.0, largest - m_mesh.rounding());
      level = morphLevel(wish, errors, largest);
    } else {
      while (level > 0 && double(wish.byDial ? errors.midpoint(level) : errors.regular(level)) > largest)
        level--;
    }
  } else {
    level = 0;
  }
  const std::size_t cell = this->cell(x, y);
  m_levels[cell] = std::uint8_t(level);
  m_places[cell] = std::uint32_t(m_drawn.size());
  m_drawn.push_back({x, y, distance, largest, kWhole});
}

int TeGeoMipMapping::morphLevel(const Wish& wish, const TeGeoMipErrors::Patch& errors, double largest) const {
  double error = 0;
  for (int level = 1; level < m_patterns.levels(); level++) {
    error = morphError(errors, level, wish.byDial, error);
    if (error > largest)
      return level - 1;
  }
  return m_patterns.levels() - 1;
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

// From 0, where the next coarser level has just been given up, to 1, where this one is.
void TeGeoMipMapping::weigh(const Wish& wish) {
  for (Drawn& drawn : m_drawn) {
    const int level = m_levels[cell(drawn.x, drawn.y)];
    if (level + 1 == m_patterns.levels())
      continue;
    const TeGeoMipErrors::Patch errors = m_errors.patch(drawn.x, drawn.y);
    double finer = 0;
    for (int i = 1; i <= level; i++)
      finer = morphError(errors, i, wish.byDial, finer);
    const double coarser = morphError(errors, level + 1, wish.byDial, finer);
    drawn.weight = 0;
    if (coarser > finer)
      raiseWeight(drawn, (coarser - drawn.largest) / (coarser - finer));
  }
}

void TeGeoMipMapping::raiseWeight(Drawn& drawn, double share) {
  // A hair more, so that rounding takes nothing away.
  drawn.weight = std::max(drawn.weight, int(std::ceil(kWhole * std::clamp(share + 1e-9, 0.0, 1.0))));
}

// A strip deviates by no more than with all vertices at their own heights, plus the farthest that one of them
// is moved. So each strip asks for a least weight of the patches whose vertices it has, whatever others ask.
void TeGeoMipMapping::raiseWeights() {
  for (Drawn& drawn : m_drawn) {
    const std::size_t here = cell(drawn.x, drawn.y);
    const int level = m_levels[here];
    const TeGeoMipErrors::Patch errors = m_errors.patch(drawn.x, drawn.y);
    const auto ask = [&](Drawn& asked, int itsLevel, double error) {
      if (itsLevel + 1 == m_patterns.levels())
        return;
      const double moved = double(errors.midpoint(itsLevel + 1)), room = drawn.largest - error;
      if (moved > room)
        raiseWeight(asked, 1 - room / moved);
    };
    const auto beyond = [&](int side) -> Drawn* {
      const std::size_t there = beside(here, side % 4);
      return m_levels[there] == kNotDrawn ? nullptr : &m_drawn[m_places[there]];
    };
    for (int side = 0; side < 4; side++) {
      Drawn* other = beyond(side);
      const int border = other ? m_levels[cell(other->x, other->y)] : 0;
      if (!other || border < level)
        continue;
      if (border == level) {
        ask(*other, level, double(errors.regular(level)));
        continue;
      }
      const double error = double(errors.stitched(level, TeGeoMipSide(side), border));
      ask(drawn, level, error);
      ask(*other, border, error);
      for (const int next : {side + 1, side + 3}) // halves of corner cells are in these strips
        if (Drawn* beside = beyond(next); beside && m_levels[cell(beside->x, beside->y)] == level)
          ask(*beside, level, error);
    }
  }
}

TeGeoMipPart TeGeoMipMapping::partOf(const Drawn& drawn, bool geomorph) const {
  const std::size_t here = cell(drawn.x, drawn.y);
  TeGeoMipPart part;
  part.x = drawn.x;
  part.y = drawn.y;
  part.level = m_levels[here];
  part.weight = drawn.weight;
  for (std::size_t side = 0; side < 4; side++) {
    part.sides[side] = part.level;
    part.borderWeights[side] = part.weight;
    const std::size_t there = beside(here, int(side));
    const int border = m_levels[there];
    if (border == kNotDrawn) // it has no border in view
      continue;
    part.sides[side] = std::max(part.level, border);
    if (!geomorph || border < part.level)
      continue;
    const int weight = m_drawn[m_places[there]].weight;
    part.borderWeights[side] = border > part.level ? weight : std::min(weight, part.weight);
  }
  return part;
}

void TeGeoMipMapping::report(const Wish& wish, TeLodSelection& selection) {
  double bound = 0;
  for (const Drawn& drawn : m_drawn) {
    const TeGeoMipPart part = partOf(drawn, wish.geomorph);
    const std::int64_t triangles = m_patterns.triangles(part.level, part.sides);
    selection.parts.push_back({part.key(m_patches), triangles});
    selection.triangles += triangles;
    bound = std::max(bound, wish.view.pixels(m_mesh.error(part) * field().heightScale(), drawn.distance));
    m_canCoarsen = m_canCoarsen || part.level + 1 < m_patterns.levels();
  }
  selection.errorBound = bound;
  selection.dial = wish.pixels;
}

void TeGeoMipMapping::appendPart(std::size_t part, TeLodMesh& mesh) const {
  m_mesh.append(TeGeoMipPart::of(selection().parts[part].key, m_patches), mesh);
}
