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

template <int... kNumbers> struct Sequence {};
template <int kCount, int... kNumbers>
struct MakeSequence : MakeSequence<kCount - 1, kCount - 1, kNumbers...> {};
template <int... kNumbers> struct MakeSequence<0, kNumbers...> { using type = Sequence<kNumbers...>; };

/// Exchanges the upper right and lower left quarters of the blocks of side 2·kDistance.
template <int kDistance, int... kLane> void exchange(Vector* rows, Sequence<kLane...>) {
  for (int i = 0; i < kLanes; ++i) {
    if (i & kDistance)
      continue;
    const Vector a = rows[i];
    const Vector b = rows[i + kDistance];
    rows[i] = __builtin_shufflevector(a, b, ((kLane & kDistance) ? kLanes + kLane - kDistance : kLane)...);
    rows[i + kDistance] =
        __builtin_shufflevector(a, b, ((kLane & kDistance) ? kLanes + kLane : kLane + kDistance)...);
  }
}

void transposeTile(const float* in, std::ptrdiff_t inStride, float* out, std::ptrdiff_t outStride) {
  using Lanes = MakeSequence<kLanes>::type;
  Vector rows[kLanes];
  for (int i = 0; i < kLanes; ++i)
    rows[i] = *reinterpret_cast<const UnalignedVector*>(in + i * inStride);
#if TE_BAND_LANES >= 16
  exchange<8>(rows, Lanes());
#endif
#if TE_BAND_LANES >= 8
  exchange<4>(rows, Lanes());
#endif
  exchange<2>(rows, Lanes());
  exchange<1>(rows, Lanes());
  for (int i = 0; i < kLanes; ++i)
    *reinterpret_cast<UnalignedVector*>(out + i * outStride) = rows[i];
}

void transpose(const float* in, std::ptrdiff_t inStride, int rows, int columns, float* out,
               std::ptrdiff_t outStride) {
  for (int y = 0; y < rows; y += kLanes)
    for (int x = 0; x < columns; x += kLanes)
      transposeTile(in + y * inStride + x, inStride, out + x * outStride + y, outStride);
}

} // namespace
