#pragma once

#include <cstdint>
#include <functional>

/// How much a slice of resumable work may do: thread CPU time, a number of work units, or anything.
/// At least one unit is always done, so that every slice makes progress.
///
///     do { one unit } while (allowance.spend());
///
/// One thread at a time. With time, spend() reads the clock once, as every question does whose answer changes
/// with time (exhausted(), elapsed(), remainingSeconds()).
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
  /// Accounts for work that is paid later, such as an upload while drawing: with time, `seconds` less are
  /// left; otherwise `units` count as spent. Both at least 0. True while more may be done.
  bool charge(double seconds, std::int64_t units);
  /// What was done since the last spend() is no part of the next unit (longestUnit()).
  void beginUnit();

  /// True if nothing more may be done.
  bool exhausted() const;

  /// Units accounted for so far.
  std::int64_t unitsSpent() const { return m_spent; }
  /// True if it counts units.
  bool countsUnits() const { return m_kind == Kind::Units; }
  /// Units that are left, not less than 0; the largest number unless it counts units.
  std::int64_t remainingUnits() const;
  /// Seconds that are left, below 0 once it is overdrawn; infinite unless it measures time.
  double remainingSeconds() const;
  /// Seconds since it was made, without what was charged; 0 unless it measures time.
  double elapsed() const;
  /// The longest time from one spend(), or beginUnit(), to the next spend(): the longest unit, in seconds. 0
  /// unless it measures time.
  double longestUnit() const { return m_longest; }

private:
  enum class Kind { Unlimited, Units, Time };
  explicit TeAllowance(Kind kind) : m_kind(kind) {}
  bool exhaustedAt(double now) const;

  Kind m_kind;
  std::int64_t m_spent = 0;
  std::int64_t m_limit = 0;
  double m_start = 0;
  double m_deadline = 0;
  double m_last = 0; ///< when the unit in work began
  double m_longest = 0;
  Clock m_clock;
};

/// CPU time of the calling thread in seconds.
double teThreadCpuSeconds();
