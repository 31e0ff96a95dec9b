#include "generators/faults/TeFaultFormation.h"

#include "generators/TeEvaluateFromMap.h"
#include "generators/base/TeFloatEnvironment.h"
#include "generators/base/TeHash.h"
#include "generators/faults/TeFaultJob.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kMaxSum = 0x1p24;
constexpr double kMinRamp = 1;
constexpr double kMaxRamp = 4096;

} // namespace

TeResult<std::shared_ptr<const TeFaultFormation>> TeFaultFormation::create(TeFaultParameters parameters) {
  if (TeStatus ok = teCheckParameters(parameters.table(), "faults"); !ok)
    return ok.error();
  return std::shared_ptr<const TeFaultFormation>(new TeFaultFormation(std::move(parameters)));
}

TeFaultFormation::TeFaultFormation(TeFaultParameters parameters)
    : m_parameters(std::move(parameters)), m_smooth(m_parameters.profile == "smooth"),
      m_fingerprint(teHashParameters(m_parameters.table(), teHashText("faults"))) {
  const TeFloatEnvironment environment;
  const int count = m_parameters.faults;
  const double fall =
      count > 1 ? (std::sqrt(m_parameters.first / m_parameters.last) - 1) / double(count - 1) : 0;
  std::vector<double> metres;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double root = 1 + i * fall;
    metres.push_back(m_parameters.first / (root * root));
    sum += metres.back();
  }
  while (sum > kMaxSum * m_unit)
    m_unit *= 2;
  while (sum <= 0.5 * kMaxSum * m_unit)
    m_unit *= 0.5;
  std::int64_t total = 0;
  for (double a : metres) {
    m_amplitudes.push_back(std::int32_t(std::floor(a / m_unit + 0.5)));
    total += m_amplitudes.back();
  }
  // Sums are in halves of the unit for the step profile, so that half of the sum is a whole number.
  m_sumUnit = float(m_smooth ? m_unit / double(TeFaultPlane::kRampFull) : 0.5 * m_unit);
  if (m_parameters.centred)
    m_level = m_smooth ? total * (TeFaultPlane::kRampFull / 2) : total;
}

TeRandom TeFaultFormation::random(const TeMapRequest& request) const {
  return TeRandom(request.worldSeed, teHashCombine(teHashText("faults"), m_parameters.seed), request.key);
}

TeFaultLine TeFaultFormation::line(const TeMapRequest& request, const TeRandom& random, int fault) const {
  const std::uint64_t a = random.at(2 * std::uint64_t(fault));
  const std::uint64_t b = random.at(2 * std::uint64_t(fault) + 1);
  const std::int64_t width = std::int64_t(request.columns) * 256;
  const std::int64_t height = std::int64_t(request.rows) * 256;
  TeFaultLine line;
  line.ax = TeRandom::scaled(std::uint32_t(a), width);
  line.ay = TeRandom::scaled(std::uint32_t(a >> 32), height);
  line.bx = TeRandom::scaled(std::uint32_t(b), width);
  line.by = TeRandom::scaled(std::uint32_t(b >> 32), height);
  if (line.by == line.ay)
    ++line.by;
  return line;
}

double TeFaultFormation::rampWidth(int fault, double spacing) const {
  const double relative = double(amplitude(fault)) * m_unit / m_parameters.first;
  return std::clamp(m_parameters.width * relative / spacing, kMinRamp, kMaxRamp);
}

TeFaultPlane TeFaultFormation::plane(const TeMapRequest& request, const TeRandom& random, int fault) const {
  if (m_smooth)
    return TeFaultPlane::smooth(line(request, random, fault), amplitude(fault),
                                rampWidth(fault, request.spacing));
  return TeFaultPlane::step(line(request, random, fault), 2 * amplitude(fault));
}

void TeFaultFormation::heights(const std::int64_t* sums, std::size_t count, float* metres) const {
  const std::int64_t level = m_level;
  const float unit = m_sumUnit;
  for (std::size_t i = 0; i < count; ++i)
    metres[i] = float(sums[i] - level) * unit;
}

std::unique_ptr<TeHeightJob> TeFaultFormation::start(const TeMapRequest& request) const {
  return std::make_unique<TeFaultJob>(std::static_pointer_cast<const TeFaultFormation>(shared_from_this()),
                                      request);
}

// A crossing costs about as much as one side test, a smooth one as seven.
bool TeFaultFormation::mapIsCheaper(const TeMapRequest& request, std::size_t count) const {
  const double area = double(request.columns) * double(request.rows);
  const double map = double(faults()) * request.rows * (m_smooth ? 7 : 1) + area;
  return area <= kTeMaxMapInstead && double(count) * faults() > map;
}

TeStatus TeFaultFormation::evaluate(const TeMapRequest& request, const TeMapSample* samples,
                                    std::size_t count, float* heights) const {
  if (mapIsCheaper(request, count))
    return teEvaluateFromMap(*this, request, samples, count, heights);
  const TeFloatEnvironment environment;
  const TeRandom stream = random(request);
  std::vector<std::int64_t> sums(count, 0);
  const std::int64_t full = m_smooth ? TeFaultPlane::kRampFull : 1;
  for (int fault = 0; fault < faults(); ++fault) {
    const TeFaultPlane p = plane(request, stream, fault);
    const std::int64_t base = p.base * full;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t value = p.value(samples[i].column, samples[i].row);
      sums[i] += base + (m_smooth ? p.smoothHeight(value) : p.stepHeight(value));
    }
  }
  this->heights(sums.data(), count, heights);
  return {};
}
