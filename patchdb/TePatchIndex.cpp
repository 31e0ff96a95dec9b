#include "patchdb/TePatchIndex.h"

#include <cassert>
#include <utility>

std::size_t TePatchIndex::Bucket::taken() const {
  std::size_t count = 0;
  while (count < kPlaces && hashes[count] != 0)
    ++count;
  return count;
}

void TePatchIndex::Bucket::drop(std::size_t place) {
  const std::size_t lastTaken = taken() - 1;
  hashes[place] = hashes[lastTaken];
  patches[place] = patches[lastTaken];
  hashes[lastTaken] = 0;
  patches[lastTaken] = nullptr;
}

void TePatchIndex::reserve(std::size_t patches) {
  if (2 * patches <= kPlaces * m_buckets.size())
    return;
  std::size_t count = 1;
  int shift = 63;
  for (; kPlaces * count < 2 * patches; count *= 2)
    --shift;
  std::vector<Bucket> buckets(count);
  std::swap(buckets, m_buckets);
  m_shift = shift;
  m_size = 0;
  for (const Bucket& bucket : buckets)
    for (std::size_t place = 0; place < bucket.taken(); ++place)
      add(*bucket.patches[place]);
}

void TePatchIndex::add(TePatchData& patch) {
  assert(2 * m_size < kPlaces * m_buckets.size());
  const std::uint64_t hash = hashOf(patch.key().x, patch.key().y);
  std::size_t i = home(hash);
  while (m_buckets[i].isFull())
    i = (i + 1) & last();
  const std::size_t place = m_buckets[i].taken();
  m_buckets[i].hashes[place] = hash;
  m_buckets[i].patches[place] = &patch;
  ++m_size;
}

// A patch that is not in its home must have full buckets only between that and its own: others move up.
void TePatchIndex::remove(const TePatchData& patch) {
  std::size_t gap = home(hashOf(patch.key().x, patch.key().y));
  std::size_t place = 0;
  const auto isIn = [&](const Bucket& bucket) {
    for (place = 0; place < kPlaces; ++place)
      if (bucket.patches[place] == &patch)
        return true;
    return false;
  };
  while (!isIn(m_buckets[gap]))
    gap = (gap + 1) & last();
  bool wasFull = m_buckets[gap].isFull();
  m_buckets[gap].drop(place);
  --m_size;
  for (std::size_t i = (gap + 1) & last(); wasFull; i = (i + 1) & last()) {
    Bucket& bucket = m_buckets[i];
    wasFull = bucket.isFull();
    for (std::size_t at = 0; at < bucket.taken(); ++at) {
      // How far it is from home, and how far from there to the gap.
      const std::size_t away = (i - home(bucket.hashes[at])) & last();
      if (away < ((i - gap) & last()))
        continue;
      Bucket& to = m_buckets[gap];
      const std::size_t free = to.taken();
      to.hashes[free] = bucket.hashes[at];
      to.patches[free] = bucket.patches[at];
      bucket.drop(at);
      gap = i;
      break;
    }
  }
}
