#pragma once

#include "engine/TeStatistics.h"
#include "engine/terrain/TePatchBlock.h"

#include <algorithm>
#include <vector>

/// How much of the block is in the scene. A patch that was found complete stays so until the block changes,
/// so that a complete block costs nothing.
class TeBlockCount {
public:
  void begin(const TePatchBlock& block) {
    m_missing.clear();
    block.forEach([this](const TePatchKey& key) { m_missing.push_back(key); });
    m_counts = {};
    m_counts.block = std::int64_t(m_missing.size());
  }
  /// Looks again at the patches that were missing; O(these).
  template <class Complete, class InView> void update(const Complete& complete, const InView& inView) {
    m_missing.erase(std::remove_if(m_missing.begin(), m_missing.end(), complete), m_missing.end());
    m_counts.missing = std::int64_t(m_missing.size());
    m_counts.drawn = m_counts.block - m_counts.missing;
    m_counts.missingInView = std::count_if(m_missing.begin(), m_missing.end(), inView);
  }
  /// Of the fields block, drawn, missing and missingInView.
  const TeStatistics::Patches& counts() const { return m_counts; }

private:
  std::vector<TePatchKey> m_missing;
  TeStatistics::Patches m_counts;
};
