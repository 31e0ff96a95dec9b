#include "generators/base/TeRandom.h"

#include "generators/base/TeHash.h"

TeRandom::TeRandom(std::uint64_t worldSeed, std::uint64_t domain, TeMapKey key) {
  std::uint64_t hash = teHashCombine(worldSeed, domain);
  hash = teHashCombine(hash, std::uint64_t(key.x));
  m_stream = teHashCombine(hash, std::uint64_t(key.y));
}

// SplitMix64 with a stream of its own as the start.
std::uint64_t TeRandom::at(std::uint64_t counter) const {
  return teMix(m_stream + (counter + 1) * 0x9E3779B97F4A7C15ull);
}

// The high half of the 128-bit product (Lemire 2019, without the rejection step).
std::uint64_t TeRandom::below(std::uint64_t bound) {
  __extension__ using Wide = unsigned __int128;
  return std::uint64_t((Wide(next()) * bound) >> 64);
}

std::int64_t TeRandom::scaled(std::uint32_t bits, std::int64_t bound) {
  __extension__ using Wide = unsigned __int128;
  return std::int64_t((Wide(bits) * std::uint64_t(bound)) >> 32);
}
