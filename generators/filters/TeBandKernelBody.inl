// The body of TeBandKernel's functions for vectors of TE_BAND_LANES floats; included by one source file for
// each kind of processor, which is compiled with that processor's instructions. Everything is local to that
// file, so that no function with such instructions can be linked in elsewhere.

#include "generators/filters/TeBandKernel.h"

namespace {

constexpr int kLanes = TE_BAND_LANES;
typedef float Vector __attribute__((vector_size(4 * kLanes)));
typedef float UnalignedVector __attribute__((vector_size(4 * kLanes), aligned(4), may_alias));

/// Columns of one strip, in vectors: enough independent recursions to hide the latency of one.
constexpr int kStrip = 8;

template <int kWidth, bool kCareful>
void sweepStrip(float* row, std::ptrdiff_t step, int count, const float* before, float k) {
  const float rest = 1.0f - k;
  const Vector largest = 3.402823466e+38f - Vector{};
  const Vector missing = __builtin_nanf("") - Vector{};
  Vector previous[kWidth];
  const float* first = before ? before : row;
  for (int v = 0; v < kWidth; ++v)
    previous[v] = *reinterpret_cast<const UnalignedVector*>(first + v * kLanes);
  for (int i = before ? 0 : 1; i < count; ++i) {
    float* current = row + i * step;
#pragma GCC unroll 8
    for (int v = 0; v < kWidth; ++v) {
      UnalignedVector& place = *reinterpret_cast<UnalignedVector*>(current + v * kLanes);
      const Vector here = place;
      Vector mixed = previous[v] * rest + here * k;
      if (kCareful) {
        mixed = previous[v] == previous[v] ? mixed : here;
        mixed = ((mixed <= largest) & (mixed >= -largest)) ? mixed : missing;
      }
      previous[v] = mixed;
      place = mixed;
    }
  }
}

template <bool kCareful>
void sweepVectors(float* row, std::ptrdiff_t step, int count, int vectors, const float* before, float k) {
  switch (vectors) {
  case 1:
    return sweepStrip<1, kCareful>(row, step, count, before, k);
  case 2:
    return sweepStrip<2, kCareful>(row, step, count, before, k);
  case 3:
    return sweepStrip<3, kCareful>(row, step, count, before, k);
  case 4:
    return sweepStrip<4, kCareful>(row, step, count, before, k);
  case 5:
    return sweepStrip<5, kCareful>(row, step, count, before, k);
  case 6:
    return sweepStrip<6, kCareful>(row, step, count, before, k);
  case 7:
    return sweepStrip<7, kCareful>(row, step, count, before, k);
  default:
    return sweepStrip<kStrip, kCareful>(row, step, count, before, k);
  }
}

/// Strips of nearly equal width: a narrow last one would wait for its few recursions.
template <bool kCareful>
void sweep(float* row, std::ptrdiff_t step, int count, int width, const float* before, float k) {
  const int vectors = width / kLanes;
  const int strips = (vectors + kStrip - 1) / kStrip;
  for (int s = 0; s < strips; ++s) {
    const int begin = vectors * s / strips;
    const int end = vectors * (s + 1) / strips;
    sweepVectors<kCareful>(row + begin * kLanes, step, count, end - begin,
                           before ? before + begin * kLanes : nullptr, k);
  }
}

/// Tiles of 8×8 where registers allow, else of 4×4.
constexpr int kTile = kLanes < 8 ? 4 : 8;
typedef float Quad __attribute__((vector_size(16), aligned(4), may_alias));
typedef float Tile __attribute__((vector_size(4 * kTile)));
typedef float UnalignedTile __attribute__((vector_size(4 * kTile), aligned(4), may_alias));

/// Four samples of a row, and with tiles of 8 those of the fourth row after it behind them: so the halves are
/// exchanged by loading, and all that is left is to transpose blocks of 4×4.
inline void loadQuads(const float* in, std::ptrdiff_t stride, Tile& tile) {
#if TE_BAND_LANES >= 8
  const Quad low = *reinterpret_cast<const Quad*>(in);
  const Quad high = *reinterpret_cast<const Quad*>(in + 4 * stride);
  tile = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  (void)stride;
  tile = *reinterpret_cast<const Quad*>(in);
#endif
}

#if TE_BAND_LANES >= 8
#define TE_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l, i + 4, j + 4, k + 4, l + 4)
#else
#define TE_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#endif

void transposeTile(const float* in, std::ptrdiff_t inStride, float* out, std::ptrdiff_t outStride) {
  for (int quad = 0; quad < kTile; quad += 4) {
    Tile a, b, c, d;
    loadQuads(in + quad, inStride, a);
    loadQuads(in + quad + inStride, inStride, b);
    loadQuads(in + quad + 2 * inStride, inStride, c);
    loadQuads(in + quad + 3 * inStride, inStride, d);
    const Tile abLow = TE_SHUFFLE(a, b, 0, kTile, 1, kTile + 1);
    const Tile abHigh = TE_SHUFFLE(a, b, 2, kTile + 2, 3, kTile + 3);
    const Tile cdLow = TE_SHUFFLE(c, d, 0, kTile, 1, kTile + 1);
    const Tile cdHigh = TE_SHUFFLE(c, d, 2, kTile + 2, 3, kTile + 3);
    const auto place = [out, outStride](int row) -> UnalignedTile& {
      return *reinterpret_cast<UnalignedTile*>(out + row * outStride);
    };
    place(quad) = TE_SHUFFLE(abLow, cdLow, 0, 1, kTile, kTile + 1);
    place(quad + 1) = TE_SHUFFLE(abLow, cdLow, 2, 3, kTile + 2, kTile + 3);
    place(quad + 2) = TE_SHUFFLE(abHigh, cdHigh, 0, 1, kTile, kTile + 1);
    place(quad + 3) = TE_SHUFFLE(abHigh, cdHigh, 2, 3, kTile + 2, kTile + 3);
  }
}

#undef TE_SHUFFLE

void transpose(const float* in, std::ptrdiff_t inStride, int rows, int columns, float* out,
               std::ptrdiff_t outStride) {
  for (int y = 0; y < rows; y += kTile)
    for (int x = 0; x < columns; x += kTile)
      transposeTile(in + y * inStride + x, inStride, out + x * outStride + y, outStride);
}

} // namespace
