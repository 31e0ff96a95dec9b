#pragma once

#include "generators/TeHeightSource.h"
#include "generators/TeParameter.h"

/// A generator with public parameters that a program may change at any time; the base class of every
/// generator (document 002, appendix B).
///
/// Derived classes have public members for their parameters, list them in parameters(), set them to their
/// defaults in setDefaults() (called by their constructor), and make an immutable source from them in
/// makeSource(). A job uses the source of the moment it was started: parameters changed meanwhile take effect
/// with the next job. Not thread-safe; the sources it makes are.
class TeGenerator {
public:
  virtual ~TeGenerator();
  TeGenerator(const TeGenerator&) = delete;
  TeGenerator& operator=(const TeGenerator&) = delete;

  virtual std::string name() const = 0;
  /// The public parameters, bound to the members.
  virtual TeParameters parameters() = 0;

  /// Copies the public parameters into the source that the next job uses. Error: a parameter is not usable;
  /// the former source then stays.
  TeStatus updateParams();
  /// The source of the last updateParams(); null before the first.
  TeHeightSourcePtr source() const { return m_source; }

  /// Begins a job with the present parameters (calls updateParams()), dropping an unfinished one.
  TeStatus start(const TeMapRequest& request);
  /// Does as much of the job as the allowance permits, at least one unit. True when the job is complete or
  /// there is none; progress() tells whether it failed.
  bool genStep(TeAllowance& allowance);
  /// Does all that is left of the job regardless of time.
  TeStatus generate();
  /// The job's state; Done if there is none.
  TeProgress progress() const;
  /// Why the job failed; only after Failed.
  const TeError& error() const;
  /// Moves the finished map out; only when progress() is Done after a start(), once.
  TeHeightMap takeMap();

protected:
  TeGenerator() = default;
  virtual void setDefaults() = 0;
  /// Called with parameters that passed teCheckParameters().
  virtual TeResult<TeHeightSourcePtr> makeSource() const = 0;

private:
  TeHeightSourcePtr m_source;
  std::unique_ptr<TeHeightJob> m_job;
};
