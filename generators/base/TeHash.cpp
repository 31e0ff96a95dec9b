#include "generators/base/TeHash.h"

#include <cstring>

std::uint64_t teHashBytes(const void* data, std::size_t bytes, std::uint64_t seed) {
  const unsigned char* p = static_cast<const unsigned char*>(data);
  std::uint64_t hash = teHashCombine(seed, std::uint64_t(bytes));
  while (bytes > 0) {
    const std::size_t n = bytes < 8 ? bytes : 8;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < n; ++i)
      word |= std::uint64_t(p[i]) << (8 * i);
    hash = teHashCombine(hash, word);
    p += n;
    bytes -= n;
  }
  return hash;
}

std::uint64_t teHashDouble(std::uint64_t hash, double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return teHashCombine(hash, bits);
}
