#include "engine/terrain/TePatchCandidates.h"

#include <algorithm>

void TePatchCandidates::clear() {
  for (std::vector<TeUrgency>& found : m_found)
    found.clear();
}

void TePatchCandidates::sort() {
  for (std::size_t kind = 0; kind < kQueued.size(); ++kind) {
    std::vector<TeUrgency>& found = m_found[kind];
    m_more[kind] = found.size() > kQueued[kind];
    if (m_more[kind]) {
      std::nth_element(found.begin(), found.begin() + std::ptrdiff_t(kQueued[kind]), found.end());
      found.resize(kQueued[kind]);
    }
    std::sort(found.begin(), found.end(), [](const TeUrgency& a, const TeUrgency& b) { return b < a; });
  }
}

bool TePatchCandidates::take(TeJobKind kind, TeUrgency& urgency) {
  std::vector<TeUrgency>& found = m_found[std::size_t(kind)];
  if (found.empty() || m_queued[std::size_t(kind)] >= kQueued[std::size_t(kind)])
    return false;
  urgency = found.back();
  found.pop_back();
  return true;
}

bool TePatchCandidates::empty() const {
  for (std::size_t kind = 0; kind < kQueued.size(); ++kind)
    if (!m_found[kind].empty() || m_more[kind])
      return false;
  return true;
}

bool TePatchCandidates::outdated() const {
  for (std::size_t kind = 0; kind < kQueued.size(); ++kind)
    if (m_found[kind].empty() && m_more[kind] && m_queued[kind] < kQueued[kind] / 2)
      return true;
  return false;
}
