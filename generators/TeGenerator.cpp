#include "generators/TeGenerator.h"

TeGenerator::~TeGenerator() = default;

TeStatus TeGenerator::updateParams() {
  if (TeStatus ok = teCheckParameters(parameters(), name()); !ok)
    return ok;
  TeResult<TeHeightSourcePtr> source = makeSource();
  if (!source)
    return source.error();
  m_source = std::move(*source);
  return {};
}

TeStatus TeGenerator::start(const TeMapRequest& request) {
  if (TeStatus ok = updateParams(); !ok)
    return ok;
  // A map of that size must be possible at all before the source is asked for it.
  if (auto possible = TeMapRequest::standalone(request.columns, request.rows, request.spacing, 0); !possible)
    return TeError{name() + ": " + possible.error().message};
  if (TeStatus ok = m_source->accepts(request.columns, request.rows); !ok)
    return ok;
  m_job = m_source->start(request);
  return {};
}

bool TeGenerator::genStep(TeAllowance& allowance) {
  return !m_job || m_job->step(allowance) != TeProgress::Working;
}

TeStatus TeGenerator::generate() {
  if (!m_job)
    return TeError{name() + ": generate() before start()"};
  if (m_job->finish() == TeProgress::Failed)
    return m_job->error();
  return {};
}

TeProgress TeGenerator::progress() const { return m_job ? m_job->progress() : TeProgress::Done; }

const TeError& TeGenerator::error() const {
  assert(m_job && m_job->progress() == TeProgress::Failed);
  return m_job->error();
}

TeHeightMap TeGenerator::takeMap() {
  assert(m_job && m_job->progress() == TeProgress::Done);
  TeHeightMap map = m_job->takeMap();
  m_job.reset();
  return map;
}
