#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// Mixes 64 bits so that every input bit changes about half of the output bits (the finaliser of SplitMix64,
/// Steele, Lea and Flood 2014). A bijection.
constexpr std::uint64_t teMix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

/// Adds a value to a running hash; order matters.
constexpr std::uint64_t teHashCombine(std::uint64_t hash, std::uint64_t value) {
  return teMix(hash + 0x9E3779B97F4A7C15ull + teMix(value));
}

/// Hash of bytes, the same on every machine of any byte order; for fingerprints and golden values, not
/// against an adversary.
std::uint64_t teHashBytes(const void* data, std::size_t bytes, std::uint64_t seed = 0);
inline std::uint64_t teHashText(std::string_view text) { return teHashBytes(text.data(), text.size()); }
/// Hash of a double's bits, so that a fingerprint tells apart any two parameter values.
std::uint64_t teHashCombine(std::uint64_t hash, double value) = delete;
std::uint64_t teHashDouble(std::uint64_t hash, double value);
