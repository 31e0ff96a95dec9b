#include "generators/midpoint/TeMidpointDisplacement.h"

#include "generators/base/TeHash.h"
#include "generators/midpoint/TeMidpointJob.h"

TeResult<std::shared_ptr<const TeMidpointDisplacement>>
TeMidpointDisplacement::create(TeMidpointParameters parameters) {
  if (TeStatus ok = teCheckParameters(parameters.table(), "midpoint"); !ok)
    return ok.error();
  return std::shared_ptr<const TeMidpointDisplacement>(new TeMidpointDisplacement(std::move(parameters)));
}

TeMidpointDisplacement::TeMidpointDisplacement(TeMidpointParameters parameters)
    : m_parameters(std::move(parameters)), m_gaussian(m_parameters.variant == "gaussian"),
      m_fingerprint(teHashParameters(m_parameters.table(), teHashText("midpoint"))) {}

TeStatus TeMidpointDisplacement::accepts(int columns, int rows) const {
  const std::int64_t cells = std::int64_t(columns) - 1;
  if (columns == rows && cells > 0 && (cells & (cells - 1)) == 0)
    return {};
  std::int64_t next = 1;
  while (next + 1 < columns || next + 1 < rows)
    next *= 2;
  const std::string side = std::to_string(next + 1);
  return TeError{"midpoint: map size " + std::to_string(columns) + "x" + std::to_string(rows) +
                 ": must be square with 2^n + 1 samples a side, the next such size is " + side + "x" + side};
}

std::unique_ptr<TeHeightJob> TeMidpointDisplacement::start(const TeMapRequest& request) const {
  return std::make_unique<TeMidpointJob>(
      std::static_pointer_cast<const TeMidpointDisplacement>(shared_from_this()), request);
}

TeRandom TeMidpointDisplacement::random(const TeMapRequest& request) const {
  return TeRandom(request.worldSeed, teHashCombine(teHashText("midpoint"), m_parameters.seed), request.key);
}

double TeMidpointDisplacement::displacement(const TeRandom& random, std::uint64_t sample) const {
  if (!m_gaussian)
    return double(std::int64_t(random.at(sample)) >> 11) * 0x1p-52;
  std::int64_t sum = 0;
  for (std::uint64_t i = 0; i < 3; ++i) {
    const std::uint64_t bits = random.at(3 * sample + i);
    sum += std::int64_t((bits & 0xffff) + (bits >> 16 & 0xffff) + (bits >> 32 & 0xffff) + (bits >> 48));
  }
  return double(sum - 6 * 0xffff) * 0x1p-16;
}
