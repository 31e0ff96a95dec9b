#include "generators/base/TeAllowance.h"

#include <ctime>

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
  a.m_deadline = a.m_clock() + seconds;
  return a;
}

bool TeAllowance::spend(std::int64_t units) {
  m_spent += units;
  return !exhausted();
}

bool TeAllowance::exhausted() const {
  switch (m_kind) {
  case Kind::Units:
    return m_spent >= m_limit;
  case Kind::Time:
    return !(m_clock() < m_deadline); // so that NaN is no licence to go on for ever
  case Kind::Unlimited:
    break;
  }
  return false;
}
