#include "nodes/lod/rtin/TeRtinTile.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

// Clones of one function (TeTargetClones.h) do not do here: types of vectors are lowered before functions are
// cloned.
#if defined(__x86_64__) && defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__clang__)
#define TE_RTIN_X86
#include <immintrin.h>
#endif

namespace {

struct TileRows {
  const float* sample; ///< of the tile's own corner (0, 0)
  float* error;
  std::ptrdiff_t x; ///< 1 or -1: from column to column of the tile
  std::ptrdiff_t y; ///< from row to row
};

namespace plain {
constexpr int kLanes = 2;
#define TE_RTIN_WIDE(a) __builtin_convertvector(a, Lanes)
#define TE_RTIN_NARROW(a) __builtin_convertvector(a, FloatLanes)
#define TE_RTIN_LESS(a, b) (a < b ? a : b)
#define TE_RTIN_MORE(a, b) (a > b ? a : b)
#ifdef TE_RTIN_X86
#define TE_RTIN_MAXIMUM(a, b) _mm_max_pd(a, b)
#else
#define TE_RTIN_MAXIMUM(a, b) (a > b ? a : b)
#endif
#include "nodes/lod/rtin/TeRtinSquares.inc"
} // namespace plain

#ifdef TE_RTIN_X86
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
constexpr int kLanes = 4;
// GCC 12 makes five instructions of a conversion that is one.
#define TE_RTIN_WIDE(a) _mm256_cvtps_pd(a)
#define TE_RTIN_NARROW(a) _mm256_cvtpd_ps(a)
#define TE_RTIN_LESS(a, b) _mm256_min_pd(a, b)
#define TE_RTIN_MORE(a, b) _mm256_max_pd(a, b)
#define TE_RTIN_MAXIMUM(a, b) _mm256_max_pd(a, b)
#include "nodes/lod/rtin/TeRtinSquares.inc"
} // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl")
namespace avx512 {
constexpr int kLanes = 8;
// The header's own functions make GCC 12 warn of what they leave open on purpose.
#define TE_RTIN_WIDE(a) __builtin_convertvector(a, Lanes)
#define TE_RTIN_NARROW(a) __builtin_convertvector(a, FloatLanes)
#define TE_RTIN_LESS(a, b) (a < b ? a : b)
#define TE_RTIN_MORE(a, b) (a > b ? a : b)
// Not negative numbers order as their bits do.
#define TE_RTIN_MAXIMUM(a, b)                                                                                \
  reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(a) > reinterpret_cast<LaneBits>(b)                      \
                              ? reinterpret_cast<LaneBits>(a)                                                \
                              : reinterpret_cast<LaneBits>(b))
#include "nodes/lod/rtin/TeRtinSquares.inc"
} // namespace avx512
#pragma GCC pop_options
#endif

int lanesHere() {
#ifdef TE_RTIN_X86
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return avx512::kLanes;
  if (__builtin_cpu_supports("avx2"))
    return avx2::kLanes;
#endif
  return plain::kLanes;
}

constexpr std::size_t kAlignment = 64;

/// Not filled: all of it is written before it is read.
std::unique_ptr<unsigned char[]> bytes(std::size_t count) {
  return std::unique_ptr<unsigned char[]>(new unsigned char[count + kAlignment]);
}

unsigned char* aligned(const std::unique_ptr<unsigned char[]>& buffer) {
  const std::size_t beyond = reinterpret_cast<std::uintptr_t>(buffer.get()) % kAlignment;
  return buffer.get() + (kAlignment - beyond) % kAlignment;
}

struct Functions {
  void (*load)(const TileRows*, double*, int);
  void (*squares)(const double*, float*, int);
  void (*store)(const TileRows*, const float*, int, int);
};

Functions functionsOf(int lanes) {
#ifdef TE_RTIN_X86
  if (lanes == avx512::kLanes)
    return {avx512::load, avx512::squares, avx512::store};
  if (lanes == avx2::kLanes)
    return {avx2::load, avx2::squares, avx2::store};
#endif
  (void)lanes;
  return {plain::load, plain::squares, plain::store};
}

} // namespace

int TeRtinTile::mostLanes() { return lanesHere(); }

TeRtinTile::TeRtinTile(int side, int lanes) : m_side(side), m_lanes(lanes == 0 ? mostLanes() : lanes) {
  const std::size_t numbers = std::size_t(side + 1) * std::size_t(side + 1) * std::size_t(m_lanes);
  m_sampleBytes = bytes(numbers * sizeof(double));
  m_errorBytes = bytes(numbers * sizeof(float));
  m_samples = reinterpret_cast<double*>(aligned(m_sampleBytes));
  m_errors = reinterpret_cast<float*>(aligned(m_errorBytes));
}

void TeRtinTile::raiseAll(const TeHeightMap& heights, float* errors) {
  const Functions functions = functionsOf(m_lanes);
  const std::ptrdiff_t width = heights.width();
  const int columns = (heights.width() - 1) / m_side, rows = (heights.height() - 1) / m_side;
  std::vector<TileRows> tiles;
  const auto flush = [&] {
    const std::size_t count = tiles.size();
    if (count == 0)
      return;
    tiles.resize(std::size_t(m_lanes), tiles.back());
    functions.load(tiles.data(), m_samples, m_side);
    functions.squares(m_samples, m_errors, m_side);
    functions.store(tiles.data(), m_errors, m_side, int(count));
    tiles.clear();
  };
  for (int row = 0; row < rows; row++)
    for (int column = 0; column < columns; column++) {
      // The diagonal of a tile ends in its parent's centre, which is east of it in even columns.
      const bool fromEast = column % 2 != 0, fromNorth = row % 2 != 0;
      const std::ptrdiff_t corner =
          std::ptrdiff_t(row + fromNorth) * m_side * width + std::ptrdiff_t(column + fromEast) * m_side;
      tiles.push_back(
          {heights.data() + corner, errors + corner, fromEast ? -1 : 1, fromNorth ? -width : width});
      if (tiles.size() == std::size_t(m_lanes))
        flush();
    }
  flush();
}
