#include "engine/jobs/TeJobQueue.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

TeJobQueue::TeJobQueue() = default;
TeJobQueue::~TeJobQueue() = default;

bool TeJobQueue::Slot::operator<(const Slot& other) const {
  if (rank != other.rank)
    return rank < other.rank;
  if (distance != other.distance)
    return distance < other.distance;
  return job->urgency() < other.job->urgency();
}

TeJobQueue::Slot TeJobQueue::makeSlot(std::unique_ptr<TeJob> job, bool started) {
  TeUrgency& urgency = job->m_urgency;
  if (std::isnan(urgency.distance)) // would make the order meaningless
    urgency.distance = std::numeric_limits<double>::infinity();
  return {urgency.rank, urgency.distance, std::move(job), started, false};
}

TeJob& TeJobQueue::add(std::unique_ptr<TeJob> job) {
  assert(job);
  TeJob& added = *job;
  insert(makeSlot(std::move(job), false));
  return added;
}

void TeJobQueue::insert(Slot slot) {
  Kind& to = kind(slot.job->kind());
  const auto at = std::upper_bound(to.slots.begin(), to.slots.end(), slot);
  to.next = std::min(to.next, std::size_t(at - to.slots.begin()));
  to.slots.insert(at, std::move(slot));
}

TeJobQueue::Slots::iterator TeJobQueue::find(const TeJob& job) {
  Slots& slots = kind(job.kind()).slots;
  const TeUrgency& urgency = job.urgency();
  auto at = std::partition_point(slots.begin(), slots.end(),
                                 [&](const Slot& slot) { return slot.job->urgency() < urgency; });
  while (at != slots.end() && at->job.get() != &job)
    ++at;
  return at;
}

void TeJobQueue::cancel(const TeJob& job) {
  Kind& of = kind(job.kind());
  const auto at = find(job);
  assert(at != of.slots.end());
  if (at == of.slots.end())
    return;
  if (&job == m_stepping) {
    at->cancelled = true;
    return;
  }
  if (std::size_t(at - of.slots.begin()) < of.next)
    --of.next;
  ++of.cancelled;
  of.slots.erase(at);
}

void TeJobQueue::clear() {
  review([](TeJob&, TeJobKind&, TeUrgency&) { return false; });
}

void TeJobQueue::review(const Review& review) {
  Slots moved;
  for (Kind& of : m_kinds) {
    std::size_t kept = 0;
    for (Slot& slot : of.slots) {
      TeJob& job = *slot.job;
      TeJobKind newKind = job.kind();
      TeUrgency urgency = job.urgency();
      if (!review(job, newKind, urgency)) {
        if (&job != m_stepping) {
          slot.job.reset();
          ++of.cancelled;
          continue;
        }
        slot.cancelled = true;
      }
      job.m_urgency = urgency;
      const bool cancelled = slot.cancelled;
      Slot reviewed = makeSlot(std::move(slot.job), slot.started);
      reviewed.cancelled = cancelled;
      if (newKind == job.kind()) {
        of.slots[kept++] = std::move(reviewed);
      } else {
        job.m_kind = newKind;
        moved.push_back(std::move(reviewed));
      }
    }
    of.slots.erase(of.slots.begin() + std::ptrdiff_t(kept), of.slots.end());
    of.next = 0;
  }
  for (Slot& slot : moved)
    kind(slot.job->kind()).slots.push_back(std::move(slot));
  for (Kind& of : m_kinds)
    if (!std::is_sorted(of.slots.begin(), of.slots.end()))
      std::sort(of.slots.begin(), of.slots.end());
}

/// Whether the kind has a job that is not blocked; `next` then is the most urgent one.
bool TeJobQueue::findReady(Kind& kind) {
  while (kind.next < kind.slots.size() && kind.slots[kind.next].job->blocked())
    ++kind.next;
  return kind.next < kind.slots.size();
}

TeJobQueue::Kind* TeJobQueue::mostUrgentKind() {
  Kind& ground = kind(TeJobKind::Ground);
  if (findReady(ground))
    return &ground;
  Kind* best = nullptr;
  for (std::size_t i = 1; i < m_kinds.size(); ++i)
    if (findReady(m_kinds[i]) && (!best || m_kinds[i].credit > best->credit))
      best = &m_kinds[i];
  return best;
}

/// Units done for one kind are credit for those that have work that is not blocked. The credits add up to 0.
void TeJobQueue::share(const Kind& worker, std::int64_t units) {
  if (&worker == &kind(TeJobKind::Ground))
    return;
  Kind* first = nullptr;
  double unclaimed = 0;
  for (std::size_t i = 1; i < m_kinds.size(); ++i) {
    Kind& of = m_kinds[i];
    const bool works = &of == &worker;
    if (!works && of.next >= of.slots.size()) {
      unclaimed += kShares[i] * double(units);
      if (of.slots.empty())
        unclaimed += std::exchange(of.credit, 0);
      continue;
    }
    if (!first)
      first = &of;
    of.credit += (kShares[i] - (works ? 1 : 0)) * double(units);
  }
  first->credit += unclaimed;
}

TeProgress TeJobQueue::stepOf(TeJob& job, TeAllowance& allowance) {
  try {
    return job.step(allowance);
  } catch (const std::bad_alloc&) {
    job.m_outOfMemory = true;
    return TeProgress::Failed;
  }
}

void TeJobQueue::step(Kind& kind, TeAllowance& allowance) {
  TeJob& job = *kind.slots[kind.next].job;
  if (!kind.slots[kind.next].started) {
    kind.slots[kind.next].started = true;
    ++kind.started;
  }
  m_stepping = &job;
  const std::int64_t before = allowance.unitsSpent();
  const TeProgress progress = stepOf(job, allowance);
  // A step that has done nothing counts, so that no job can hold up the loop.
  if (allowance.unitsSpent() == before && progress == TeProgress::Working && !job.blocked())
    allowance.spend();
  m_stepping = nullptr;

  Kind& now = this->kind(job.kind()); // the step may have led to a review
  share(now, allowance.unitsSpent() - before);
  const auto at = find(job);
  if (progress == TeProgress::Working && !at->cancelled)
    return;
  const bool cancelled = at->cancelled;
  const std::unique_ptr<TeJob> ended = std::move(at->job);
  if (std::size_t(at - now.slots.begin()) < now.next)
    --now.next;
  now.slots.erase(at);
  ++(cancelled ? now.cancelled : progress == TeProgress::Done ? now.finished : now.failed);
  if (!cancelled && m_finished)
    m_finished(*ended, progress);
}

bool TeJobQueue::run(TeAllowance& allowance) {
  for (Kind& of : m_kinds)
    of.next = 0;
  const std::int64_t before = allowance.unitsSpent();
  do {
    Kind* next = mostUrgentKind();
    if (!next)
      break;
    step(*next, allowance);
  } while (!allowance.exhausted());
  return allowance.unitsSpent() > before;
}

std::size_t TeJobQueue::size() const {
  std::size_t jobs = 0;
  for (const Kind& of : m_kinds)
    jobs += of.slots.size();
  return jobs;
}

bool TeJobQueue::allBlocked() const {
  for (const Kind& of : m_kinds)
    for (const Slot& slot : of.slots)
      if (!slot.job->blocked())
        return false;
  return !empty();
}

void TeJobQueue::count(TeStatistics::Jobs& jobs) const {
  for (std::size_t i = 0; i < m_kinds.size(); ++i) {
    const Kind& of = m_kinds[i];
    jobs.now[i].fill(0);
    for (const Slot& slot : of.slots)
      ++jobs.now[i][std::size_t(slot.job->state())];
    jobs.started[i] = of.started;
    jobs.finished[i] = of.finished;
    jobs.cancelled[i] = of.cancelled;
    jobs.failed[i] = of.failed;
  }
}
