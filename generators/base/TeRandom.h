#pragma once

#include "generators/TeLattice.h"

#include <cstdint>

/// A counter-based random stream: number i is a pure function of (world seed, domain, map key, i), so any
/// map can be made again, in any order, on any machine. `domain` tells the users of a key apart (usually the
/// hash of a generator's name and of its own seed parameter). Passes as many values as anyone will draw; not
/// for cryptography. Cost: about 2 ns a number.
class TeRandom {
public:
  TeRandom(std::uint64_t worldSeed, std::uint64_t domain, TeMapKey key);

  /// Number `counter` of the stream, uniform over 64 bits.
  std::uint64_t at(std::uint64_t counter) const;
  /// The next number: at(0), at(1), ...
  std::uint64_t next() { return at(m_counter++); }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return double(next() >> 11) * 0x1p-53; }
  /// Uniform in [low, high); high itself only by rounding, where few doubles lie between the two.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 .. bound-1; bound ≥ 1. The bias is below bound·2^-64.
  std::uint64_t below(std::uint64_t bound);
  /// Uniform in 0 .. bound-1 from 32 random bits; bound ≥ 1. For two or more draws from one number of a
  /// stream.
  static std::int64_t scaled(std::uint32_t bits, std::int64_t bound);

private:
  std::uint64_t m_stream;
  std::uint64_t m_counter = 0;
};
