#include "generators/TeHeightSource.h"

#include "generators/base/TeFloatEnvironment.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

TeMapRequest TeMapRequest::sourceMap(const TeLattice& lattice, std::uint64_t worldSeed, TeMapKey key) {
  TeMapRequest request;
  request.columns = request.rows = lattice.samples();
  request.spacing = lattice.spacing();
  request.firstX = lattice.mapFirstSample(key.x);
  request.firstY = lattice.mapFirstSample(key.y);
  request.originHalfCells = lattice.cells();
  request.worldSeed = worldSeed;
  request.key = key;
  return request;
}

TeResult<TeMapRequest> TeMapRequest::standalone(int columns, int rows, double spacing,
                                                std::uint64_t worldSeed) {
  if (columns < 1 || rows < 1 || std::int64_t(columns) * rows > TeHeightMap::kMaxSamples)
    return TeError{"map size " + std::to_string(columns) + "x" + std::to_string(rows) +
                   ": both sides must be positive and the area at most " +
                   std::to_string(TeHeightMap::kMaxSamples) + " samples"};
  if (!(spacing > 0) || !std::isfinite(spacing))
    return TeError{"spacing: " + std::to_string(spacing) + " is not a positive number of metres"};
  TeMapRequest request;
  request.columns = columns;
  request.rows = rows;
  request.spacing = spacing;
  request.worldSeed = worldSeed;
  return request;
}

TeHeightJob::~TeHeightJob() = default;
TeHeightSource::~TeHeightSource() = default;

TeProgress TeHeightJob::step(TeAllowance& allowance) {
  if (m_progress != TeProgress::Working)
    return m_progress;
  const TeFloatEnvironment environment;
  try {
    do {
      m_progress = unit();
    } while (allowance.spend() && m_progress == TeProgress::Working);
  } catch (const std::bad_alloc&) {
    m_progress = fail(TeError{"out of memory"}); // short enough to need none
  }
  return m_progress;
}

TeProgress TeHeightJob::finish() {
  TeAllowance all = TeAllowance::unlimited();
  return step(all);
}

TeHeightMap TeHeightJob::takeMap() {
  assert(m_progress == TeProgress::Done);
  return std::move(m_map);
}

TeProgress TeHeightJob::fail(TeError error) {
  m_error = std::move(error);
  return TeProgress::Failed;
}

TeStatus TeHeightSource::accepts(int, int) const { return {}; }

TeResult<TeHeightMap> TeHeightSource::generate(const TeMapRequest& request) const {
  if (auto possible = TeMapRequest::standalone(request.columns, request.rows, request.spacing, 0); !possible)
    return TeError{name() + ": " + possible.error().message};
  if (TeStatus ok = accepts(request.columns, request.rows); !ok)
    return ok.error();
  std::unique_ptr<TeHeightJob> job = start(request);
  if (job->finish() == TeProgress::Failed)
    return job->error();
  return job->takeMap();
}

TeStatus TeHeightSource::evaluate(const TeMapRequest&, const TeMapSample*, std::size_t, float*) const {
  return TeError{name() + ": cannot be evaluated at scattered points"};
}

namespace {

/// Fills a map row by row in runs of samples.
class PointJob final : public TeHeightJob {
public:
  PointJob(std::shared_ptr<const TePointSource> source, const TeMapRequest& request, int run)
      : m_source(std::move(source)), m_request(request), m_run(run) {}

protected:
  TeProgress unit() override {
    if (m_map.empty()) {
      TeResult<TeHeightMap> map = TeHeightMap::create(m_request.columns, m_request.rows);
      if (!map)
        return fail(map.error());
      m_map = std::move(*map);
    }
    const int count = std::min(m_run, m_request.columns - m_next.column);
    if (TeStatus ok = m_source->evaluateRun(m_request, m_next, count, m_map.row(m_next.row) + m_next.column);
        !ok)
      return fail(ok.error());
    m_next.column += count;
    if (m_next.column == m_request.columns)
      m_next = {0, m_next.row + 1};
    return m_next.row == m_request.rows ? TeProgress::Done : TeProgress::Working;
  }

private:
  std::shared_ptr<const TePointSource> m_source;
  TeMapRequest m_request;
  int m_run;
  TeMapSample m_next;
};

} // namespace

std::unique_ptr<TeHeightJob> TePointSource::start(const TeMapRequest& request) const {
  auto self = std::static_pointer_cast<const TePointSource>(shared_from_this());
  return std::make_unique<PointJob>(std::move(self), request, samplesPerUnit());
}

TeStatus TePointSource::evaluateRun(const TeMapRequest& request, TeMapSample first, int count,
                                    float* heights) const {
  std::vector<TeMapSample> samples(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    samples[std::size_t(i)] = {first.column + i, first.row};
  return evaluate(request, samples.data(), samples.size(), heights);
}
