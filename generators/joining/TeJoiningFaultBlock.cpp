#include "generators/joining/TeJoiningFaultBlock.h"

#include "generators/base/TeFloatEnvironment.h"
#include "generators/base/TeHash.h"

#include <algorithm>
#include <cassert>

namespace {

constexpr int kFaultsPerUnit = 1024;
constexpr std::int64_t kMaxFaults = std::int64_t(1) << 26;
constexpr std::uint64_t kNumbersPerFault = 4;

TeError tooMuch(const char* what, const TeJoiningFaultParameters& p) {
  return TeError{"joining faults: " + std::to_string(p.columns) + "x" + std::to_string(p.rows) + " maps of " +
                 std::to_string(p.samples) + " samples a side are too many " + what};
}

} // namespace

TeResult<TeJoiningFaultBlock> TeJoiningFaultBlock::create(const TeJoiningFaultParameters& p) {
  auto formation = TeFaultFormation::create(p.faults);
  if (!formation)
    return TeError{"joining " + formation.error().message};
  if ((*formation)->isSmooth())
    return TeError{"joining faults: profile is 'smooth', must be step"};
  if (p.samples < 3 || p.samples > TeLattice::kMaxSamples)
    return TeError{"joining faults: samples is " + std::to_string(p.samples) + ", must be 3 to " +
                   std::to_string(TeLattice::kMaxSamples)};
  if (p.overlap < 1 || p.overlap >= p.samples)
    return TeError{"joining faults: overlap is " + std::to_string(p.overlap) +
                   ", must be 1 to one less than the samples of a side"};
  if (p.columns < 1 || p.rows < 1)
    return TeError{"joining faults: a block of " + std::to_string(p.columns) + "x" + std::to_string(p.rows) +
                   " maps, both numbers must be positive"};
  const std::int64_t side = p.samples + 2 * std::int64_t(p.overlap);
  const std::int64_t maps = std::int64_t(p.columns) * p.rows;
  if (maps > TeHeightMap::kMaxSamples || maps * side > TeHeightMap::kMaxSamples ||
      maps * side * side > TeHeightMap::kMaxSamples)
    return tooMuch("samples", p);
  if (maps * p.faults.faults > kMaxFaults)
    return tooMuch("faults", p);
  return TeJoiningFaultBlock(p, std::move(*formation));
}

TeJoiningFaultBlock::TeJoiningFaultBlock(const TeJoiningFaultParameters& parameters,
                                         std::shared_ptr<const TeFaultFormation> formation)
    : m_parameters(parameters), m_formation(std::move(formation)),
      m_maps(std::size_t(parameters.columns) * std::size_t(parameters.rows)), m_faults(m_maps.size()) {}

bool TeJoiningFaultBlock::step(TeAllowance& allowance) {
  const TeFloatEnvironment environment;
  while (!done()) {
    unit();
    if (!allowance.spend())
      break;
  }
  return done();
}

void TeJoiningFaultBlock::finish() {
  TeAllowance all = TeAllowance::unlimited();
  step(all);
}

void TeJoiningFaultBlock::unit() {
  const int i = m_next % m_parameters.columns;
  const int j = m_next / m_parameters.columns;
  TeHeightMap& map = m_maps[std::size_t(m_next)];
  if (!m_painter) {
    TeResult<TeHeightMap> empty = TeHeightMap::create(physicalSamples(), physicalSamples());
    assert(empty);
    map = std::move(*empty);
    m_painter = std::make_unique<TeFaultPainter>(*m_formation);
  }
  if (int(m_faults[std::size_t(m_next)].size()) < m_formation->faults()) {
    chooseFaults(i, j);
    return;
  }
  if (!m_painter->paint(map))
    return;
  takeOverlaps(i, j);
  m_painter.reset();
  ++m_next;
}

void TeJoiningFaultBlock::chooseFaults(int i, int j) {
  std::vector<TeJoiningFault>& faults = m_faults[index(i, j)];
  const int begin = int(faults.size());
  const int end = std::min(begin + kFaultsPerUnit, m_formation->faults());
  for (int k = begin; k < end; ++k) {
    faults.push_back(chooseFault(i, j, k));
    m_painter->add(TeFaultPlane::step(faults.back().line(m_parameters.samples - 1, m_parameters.overlap),
                                      2 * m_formation->amplitude(k)));
  }
}

// Always finds a type: of a map's corners all but the north-eastern one can be given, and that one is free;
// only all equal and two diagonal pairs are no types, never both for the two values of the free corner.
TeJoiningFault TeJoiningFaultBlock::chooseFault(int i, int j, int k) const {
  const TeRandom random(m_parameters.worldSeed,
                        teHashCombine(teHashText("joining-faults"), m_parameters.faults.seed), {i, j});
  const std::uint64_t first = kNumbersPerFault * std::uint64_t(k);
  const TeJoiningFault* const west = i > 0 ? &fault(i - 1, j, k) : nullptr;
  const TeJoiningFault* const south = j > 0 ? &fault(i, j - 1, k) : nullptr;
  int candidates[12];
  int count = 0;
  for (int number = 1; number <= 12; ++number) {
    const TeFaultType type = TeFaultType::numbered(number);
    if ((!west || west->type.fits(TeMapSide::East, type)) &&
        (!south || south->type.fits(TeMapSide::North, type)))
      candidates[count++] = number;
  }
  assert(count > 0);
  TeJoiningFault fault;
  fault.type = TeFaultType::numbered(candidates[(random.at(first) >> 32) * std::uint64_t(count) >> 32]);
  std::uint64_t next = first + 1;
  for (TeMapSide side : {TeMapSide::South, TeMapSide::East, TeMapSide::North, TeMapSide::West}) {
    if (!fault.type.meets(side))
      continue;
    if (side == TeMapSide::South && south)
      fault.on(side) = south->on(TeMapSide::North);
    else if (side == TeMapSide::West && west)
      fault.on(side) = west->on(TeMapSide::East);
    else
      fault.on(side) = randomCoordinate(random.at(next++));
  }
  // A line must not lie along a row; the eastern end is never given.
  if (fault.type.meets(TeMapSide::West) && fault.type.meets(TeMapSide::East) &&
      fault.on(TeMapSide::West) == fault.on(TeMapSide::East))
    fault.on(TeMapSide::East) += fault.on(TeMapSide::East) % 256 == 255 ? -1 : 1;
  return fault;
}

std::int32_t TeJoiningFaultBlock::randomCoordinate(std::uint64_t random) const {
  const std::uint64_t cell = (random >> 32) * std::uint64_t(m_parameters.samples - 1) >> 32;
  const std::uint64_t fraction = 1 + ((random & 0xffffffff) * 255 >> 32);
  return std::int32_t(256 * cell + fraction);
}

void TeJoiningFaultBlock::takeOverlaps(int i, int j) {
  const int cells = m_parameters.samples - 1;
  const int side = physicalSamples();
  const int width = 2 * m_parameters.overlap + 1;
  TeHeightMap& map = m_maps[index(i, j)];
  if (i > 0) {
    [[maybe_unused]] const TeStatus ok =
        map.copy(m_maps[index(i - 1, j)], {cells, 0, width, side}, {0, 0, width, side});
    assert(ok);
  }
  if (j > 0) {
    [[maybe_unused]] const TeStatus ok =
        map.copy(m_maps[index(i, j - 1)], {0, cells, side, width}, {0, 0, side, width});
    assert(ok);
  }
}
