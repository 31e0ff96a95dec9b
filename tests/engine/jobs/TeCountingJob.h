#pragma once

#include "engine/jobs/TeJob.h"

#include <functional>

/// A job of some units that does nothing but count them.
class TeCountingJob final : public TeJob {
public:
  TeCountingJob(TeJobKind kind, const TeUrgency& urgency, std::int64_t units = 1)
      : TeJob(kind, urgency), m_left(units) {}

  TeProgress step(TeAllowance& allowance) override {
    if (m_blocked)
      return TeProgress::Working;
    do {
      ++m_done;
      if (m_onUnit)
        m_onUnit(*this);
    } while (allowance.spend() && m_done < m_left);
    if (m_fails && m_done >= m_left)
      return TeProgress::Failed;
    return m_done < m_left ? TeProgress::Working : TeProgress::Done;
  }
  TeJobState state() const override { return m_done == 0 ? TeJobState::Waiting : TeJobState::Blend; }
  bool blocked() const override { return m_blocked; }
  const TeError& error() const override { return m_error; }

  std::int64_t done() const { return m_done; }

  bool m_blocked = false;
  bool m_fails = false;
  std::function<void(TeCountingJob&)> m_onUnit;

private:
  std::int64_t m_left;
  std::int64_t m_done = 0;
  TeError m_error{"no luck"};
};
