#include "generators/noise/TeNoiseSource.h"

#include "generators/base/TeFloatEnvironment.h"
#include "generators/base/TeHash.h"

#include <algorithm>

namespace {

std::int64_t halfCells(std::int64_t globalSample, const TeMapRequest& request) {
  return 2 * globalSample - request.originHalfCells;
}

/// Fills a map in runs within rows, with one plan for all of it.
class NoiseJob final : public TeHeightJob {
public:
  NoiseJob(std::shared_ptr<const TeHeightSource> source, const TeNoiseSettings& settings,
           const TeNoiseKernel& kernel, const TeMapRequest& request)
      : m_source(std::move(source)), m_kernel(kernel), m_request(request),
        m_plan(settings, request.worldSeed, request.spacing) {}

protected:
  TeProgress unit() override {
    if (m_map.empty()) {
      TeResult<TeHeightMap> map = TeHeightMap::create(m_request.columns, m_request.rows);
      if (!map)
        return fail(map.error());
      m_map = std::move(*map);
    }
    for (int left = kSamplesPerUnit; left > 0 && m_next.row < m_request.rows;) {
      const int count = std::min(left, m_request.columns - m_next.column);
      m_kernel.row(m_plan, halfCells(m_request.globalX(m_next.column), m_request),
                   halfCells(m_request.globalY(m_next.row), m_request), count,
                   m_map.row(m_next.row) + m_next.column);
      left -= count;
      m_next.column += count;
      if (m_next.column == m_request.columns)
        m_next = {0, m_next.row + 1};
    }
    return m_next.row == m_request.rows ? TeProgress::Done : TeProgress::Working;
  }

private:
  static constexpr int kSamplesPerUnit = 1024; // 0.2 ms for the slowest type on the slowest path

  std::shared_ptr<const TeHeightSource> m_source;
  const TeNoiseKernel& m_kernel;
  TeMapRequest m_request;
  TeNoisePlan m_plan;
  TeMapSample m_next;
};

} // namespace

TeResult<TeHeightSourcePtr> TeNoiseSource::create(const TeNoiseSettings& settings,
                                                  const TeNoiseKernel& kernel) {
  if (TeStatus ok = settings.check(); !ok)
    return ok.error();
  return TeHeightSourcePtr(new TeNoiseSource(settings, kernel));
}

std::uint64_t TeNoiseSource::fingerprint() const {
  TeNoiseSettings settings = m_settings;
  return teHashParameters(settings.parameters(),
                          teHashCombine(teHashText(name()), std::uint64_t(settings.type)));
}

std::unique_ptr<TeHeightJob> TeNoiseSource::start(const TeMapRequest& request) const {
  const TeFloatEnvironment environment;
  return std::make_unique<NoiseJob>(shared_from_this(), m_settings, m_kernel, request);
}

TeStatus TeNoiseSource::evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                                 float* heights) const {
  const TeFloatEnvironment environment;
  const TeNoisePlan plan(m_settings, request.worldSeed, request.spacing);
  constexpr std::size_t kChunk = 256;
  std::int64_t halfX[kChunk];
  std::int64_t halfY[kChunk];
  for (std::size_t first = 0; first < count; first += kChunk) {
    const std::size_t chunk = std::min(kChunk, count - first);
    for (std::size_t i = 0; i < chunk; ++i) {
      halfX[i] = halfCells(request.globalX(samples[first + i].column), request);
      halfY[i] = halfCells(request.globalY(samples[first + i].row), request);
    }
    m_kernel.points(plan, halfX, halfY, int(chunk), heights + first);
  }
  return {};
}

TeStatus TeNoiseSource::evaluateRun(const TeMapRequest& request, TeMapSample first, int count,
                                    float* heights) const {
  const TeFloatEnvironment environment;
  const TeNoisePlan plan(m_settings, request.worldSeed, request.spacing);
  m_kernel.row(plan, halfCells(request.globalX(first.column), request),
               halfCells(request.globalY(first.row), request), count, heights);
  return {};
}
