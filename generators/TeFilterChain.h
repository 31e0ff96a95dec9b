#pragma once

#include "generators/TeFilter.h"
#include "generators/TeGenerator.h"

#include <memory>
#include <vector>

/// A generator and the filters over it, in order: together one generator.
///
/// Its parameters are the generator's under their own names, and each filter's as `band.k`; a second filter
/// of the same kind is `band2.k`, and so on.
class TeFilterChain final : public TeGenerator {
public:
  TeFilterChain(std::unique_ptr<TeGenerator> generator, std::vector<std::unique_ptr<TeFilter>> filters);

  /// Names of the parts joined by '+': `faults+band`.
  std::string name() const override;
  TeParameters parameters() override;

  TeGenerator& generator() { return *m_generator; }
  TeFilter& filter(std::size_t index) { return *m_filters[index]; }

protected:
  /// The parts set their own defaults when they are made.
  void setDefaults() override {}
  TeResult<TeHeightSourcePtr> makeSource() const override;

private:
  std::unique_ptr<TeGenerator> m_generator;
  std::vector<std::unique_ptr<TeFilter>> m_filters;
};
