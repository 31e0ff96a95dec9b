#pragma once

#include "generators/base/TeHash.h"
#include "tests/generators/TeEveryGenerator.h"

#include <cstdint>

/// The bits of every registered generator and filter with default parameters, as hashes. They may change only
/// together with a generator's definition; a change of compiler, options or processor must not change them.
struct TeGoldenHash {
  const char* chain;
  std::uint64_t hash;
};

inline constexpr TeGoldenHash kGoldenHashes[] = {
#include "tests/hard_cases/generators/goldenHashes.h"
};

/// Hash over three source maps of 33×33 samples; 0 if one cannot be made.
inline std::uint64_t teHashOf(const TeChainUnderTest& chain) {
  const auto source = TeGeneratorRegistry::instance().source(chain.generator, chain.filters);
  if (!source)
    return 0;
  const TeLattice lattice = TeLattice::create(33, 7.5).value();
  std::uint64_t hash = 0;
  for (const TeMapKey& key : {TeMapKey{0, 0}, TeMapKey{-3, 7}, TeMapKey{(std::int64_t(1) << 40) + 5, -7}}) {
    const auto map = (*source)->generate(TeMapRequest::sourceMap(lattice, 2007, key));
    if (!map)
      return 0;
    hash = teHashBytes(map->data(), map->bytes(), hash);
  }
  return hash;
}

/// The golden hash of a chain; 0 if there is none.
inline std::uint64_t teGoldenHashOf(const TeChainUnderTest& chain) {
  for (const TeGoldenHash& golden : kGoldenHashes)
    if (chain.name() == golden.chain)
      return golden.hash;
  return 0;
}
