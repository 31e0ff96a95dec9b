#pragma once

#include "generators/TeHeightSource.h"
#include "generators/TeParameter.h"

#include <memory>
#include <string>

/// A filter with public parameters that a program may change at any time; the base class of every filter.
///
/// Like TeGenerator a mutable adapter: derived classes have public members for their parameters, list them in
/// parameters() and set them to their defaults in setDefaults() (called by their constructor). apply() makes
/// an immutable source that filters the maps of another one; later changes do not touch it. Not thread-safe;
/// the sources it makes are.
class TeFilter {
public:
  virtual ~TeFilter();
  TeFilter(const TeFilter&) = delete;
  TeFilter& operator=(const TeFilter&) = delete;

  virtual std::string name() const = 0;
  /// The public parameters, bound to the members.
  virtual TeParameters parameters() = 0;

  /// The source `input` (never null) with this filter, as its parameters are now, over it. Error: a parameter
  /// is not usable.
  TeResult<TeHeightSourcePtr> apply(TeHeightSourcePtr input);

protected:
  TeFilter() = default;
  virtual void setDefaults() = 0;
  /// Called with parameters that passed teCheckParameters().
  virtual TeResult<TeHeightSourcePtr> makeSource(TeHeightSourcePtr input) const = 0;
};
