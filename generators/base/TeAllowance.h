#pragma once

#include <cstdint>
#include <functional>

/// How much a slice of resumable work may do: thread CPU time, a number of work units, or anything.
/// At least one unit is always done, so that every slice makes progress.
///
///     do { one unit } while (allowance.spend());
class TeAllowance {
public:
  /// Seconds of CPU time of the calling thread, or of an injected clock.
  using Clock = std::function<double()>;

  static TeAllowance unlimited() { return TeAllowance(Kind::Unlimited); }
  static TeAllowance units(std::int64_t count);
  static TeAllowance seconds(double seconds); ///< NaN, like 0, allows one unit
  static TeAllowance seconds(double seconds, Clock clock);

  /// Accounts for finished units; true while more may be done.
  bool spend(std::int64_t units = 1);

  /// True if nothing more may be done.
  bool exhausted() const;

  /// Units accounted for so far.
  std::int64_t unitsSpent() const { return m_spent; }

private:
  enum class Kind { Unlimited, Units, Time };
  explicit TeAllowance(Kind kind) : m_kind(kind) {}

  Kind m_kind;
  std::int64_t m_spent = 0;
  std::int64_t m_limit = 0;
  double m_deadline = 0;
  Clock m_clock;
};

/// CPU time of the calling thread in seconds.
double teThreadCpuSeconds();
