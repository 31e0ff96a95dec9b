#include "generators/circles/TeCircles.h"

#include "generators/TeEvaluateFromMap.h"
#include "generators/base/TeFloatEnvironment.h"
#include "generators/base/TeHash.h"
#include "generators/base/TeText.h"
#include "generators/circles/TeCirclesJob.h"

#include <algorithm>
#include <vector>

namespace {

constexpr double kMinRadius = 1;
constexpr double kMaxRadius = 16384;
constexpr double kMapInstead = 0.1; // part of its samples from which on that is cheaper

} // namespace

TeResult<std::shared_ptr<const TeCircles>> TeCircles::create(TeCirclesParameters parameters) {
  if (TeStatus ok = teCheckParameters(parameters.table(), "circles"); !ok)
    return ok.error();
  if (parameters.smallest > parameters.largest)
    return TeError{"circles: smallest is " + teNumberText(parameters.smallest) +
                   ", must be at most largest, " + teNumberText(parameters.largest)};
  return std::shared_ptr<const TeCircles>(new TeCircles(parameters));
}

TeCircles::TeCircles(const TeCirclesParameters& parameters)
    : m_parameters(parameters), m_fingerprint(teHashParameters(m_parameters.table(), teHashText("circles"))) {
}

std::unique_ptr<TeHeightJob> TeCircles::start(const TeMapRequest& request) const {
  return std::make_unique<TeCirclesJob>(std::static_pointer_cast<const TeCircles>(shared_from_this()),
                                        request);
}

TeRandom TeCircles::random(const TeMapRequest& request) const {
  return TeRandom(request.worldSeed, teHashCombine(teHashText("circles"), m_parameters.seed), request.key);
}

TeCircle TeCircles::circle(const TeMapRequest& request, const TeRandom& random, int index) const {
  const std::uint64_t shape = random.at(2 * std::uint64_t(index));
  const std::uint64_t place = random.at(2 * std::uint64_t(index) + 1);
  const double u = double(std::uint32_t(shape)) * 0x1p-32;
  const double v = double(std::int32_t(shape >> 32)) * 0x1p-31;
  const double metres = m_parameters.smallest + (m_parameters.largest - m_parameters.smallest) * (u * u);
  TeCircle circle;
  circle.radius = std::clamp(metres / request.spacing, kMinRadius, kMaxRadius);
  circle.height = float(m_parameters.height * (metres / m_parameters.largest) * v);
  // In 1/256 of a sample from the outer corner of the margin; sample (0, 0) is at margin + 128.
  const std::int64_t margin = std::int64_t(256 * circle.radius) + 1;
  const std::int64_t x =
      TeRandom::scaled(std::uint32_t(place), std::int64_t(request.columns) * 256 + 2 * margin) - margin - 128;
  const std::int64_t y =
      TeRandom::scaled(std::uint32_t(place >> 32), std::int64_t(request.rows) * 256 + 2 * margin) - margin -
      128;
  circle.column = x >> 8;
  circle.row = y >> 8;
  circle.eastward = float(x & 255) / 256;
  circle.northward = float(y & 255) / 256;
  return circle;
}

TeStatus TeCircles::evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                             float* heights) const {
  const double area = double(request.columns) * double(request.rows);
  if (area <= kTeMaxMapInstead && double(count) > kMapInstead * area)
    return teEvaluateFromMap(*this, request, samples, count, heights);
  const TeFloatEnvironment environment;
  const TeRandom stream = random(request);
  std::vector<std::int32_t> columns(count);
  std::vector<std::int32_t> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    columns[i] = samples[i].column;
    rows[i] = samples[i].row;
    heights[i] = 0;
  }
  for (int index = 0; index < m_parameters.circles; ++index)
    circle(request, stream, index).addToPoints(columns.data(), rows.data(), count, heights);
  return {};
}
