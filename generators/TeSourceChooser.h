#pragma once

#include "generators/TeHeightSource.h"

/// Decides which source makes which source map, so that a world may have different landscapes in different
/// regions; where they meet, four-map blending leads from one to the other. Pure like the sources: choose()
/// gives the same source, or one of the same fingerprint, for the same key whenever it is asked. Thread-safe.
class TeSourceChooser {
public:
  virtual ~TeSourceChooser() = default;
  /// Never null.
  virtual TeHeightSourcePtr choose(const TeMapKey& key) const = 0;
  /// True if all maps that it chooses agree where they overlap, so that no blending is needed.
  virtual bool fits() const = 0;
  /// True if every source it can choose can be evaluated at scattered points.
  virtual bool pointEvaluable() const = 0;
};

/// The same source everywhere.
class TeSingleSource final : public TeSourceChooser {
public:
  explicit TeSingleSource(TeHeightSourcePtr source) : m_source(std::move(source)) {}
  TeHeightSourcePtr choose(const TeMapKey&) const override { return m_source; }
  bool fits() const override { return m_source->fits(); }
  bool pointEvaluable() const override { return m_source->pointEvaluable(); }

private:
  TeHeightSourcePtr m_source;
};
