#include "generators/base/TeAllowance.h"

#include <algorithm>
#include <cassert>
#include <ctime>
#include <limits>

double teThreadCpuSeconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

TeAllowance TeAllowance::units(std::int64_t count) {
  TeAllowance a(Kind::Units);
  a.m_limit = count;
  return a;
}

TeAllowance TeAllowance::seconds(double seconds) { return TeAllowance::seconds(seconds, teThreadCpuSeconds); }

TeAllowance TeAllowance::seconds(double seconds, Clock clock) {
  TeAllowance a(Kind::Time);
  a.m_clock = std::move(clock);
  a.m_start = a.m_last = a.m_clock();
  a.m_deadline = a.m_start + seconds;
  return a;
}

bool TeAllowance::spend(std::int64_t units) {
  m_spent += units;
  if (m_kind != Kind::Time)
    return !exhaustedAt(0);
  const double now = m_clock();
  m_longest = std::max(m_longest, now - m_last);
  m_last = now;
  return !exhaustedAt(now);
}

bool TeAllowance::charge(double seconds, std::int64_t units) {
  assert(seconds >= 0 && units >= 0);
  m_spent += units;
  m_deadline -= seconds;
  return !exhausted();
}

void TeAllowance::beginUnit() {
  if (m_kind == Kind::Time)
    m_last = m_clock();
}

bool TeAllowance::exhausted() const { return exhaustedAt(m_kind == Kind::Time ? m_clock() : 0); }

bool TeAllowance::exhaustedAt(double now) const {
  switch (m_kind) {
  case Kind::Units:
    return m_spent >= m_limit;
  case Kind::Time:
    return !(now < m_deadline); // so that NaN is no licence to go on for ever
  case Kind::Unlimited:
    break;
  }
  return false;
}

std::int64_t TeAllowance::remainingUnits() const {
  if (m_kind != Kind::Units)
    return std::numeric_limits<std::int64_t>::max();
  return m_spent < m_limit ? m_limit - m_spent : 0;
}

double TeAllowance::remainingSeconds() const {
  return m_kind == Kind::Time ? m_deadline - m_clock() : std::numeric_limits<double>::infinity();
}

double TeAllowance::elapsed() const { return m_kind == Kind::Time ? m_clock() - m_start : 0; }
