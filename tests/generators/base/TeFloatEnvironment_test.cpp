#include "generators/base/TeFloatEnvironment.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cfloat>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace {

// Not inlined, and through volatile, so that the sums happen at run time.
float half(float number) {
  volatile float n = number;
  volatile float result = n * 0.5f;
  return result;
}

double oneAndABit() {
  volatile double one = 1.0;
  volatile double bit = 1e-30;
  volatile double result = one + bit;
  return result;
}

} // namespace

TEST(TeFloatEnvironment, RoundsToNearestWhateverTheCallerDid) {
  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  EXPECT_GT(oneAndABit(), 1.0);
  {
    const TeFloatEnvironment environment;
    EXPECT_EQ(oneAndABit(), 1.0);
  }
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  EXPECT_GT(oneAndABit(), 1.0);
  ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
}

#if defined(__x86_64__)
TEST(TeFloatEnvironment, KeepsDenormalsWhateverTheCallerDid) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);
  EXPECT_EQ(half(FLT_MIN), 0.0f);
  {
    const TeFloatEnvironment environment;
    EXPECT_GT(half(FLT_MIN), 0.0f);
    const TeFloatEnvironment nested;
    EXPECT_GT(half(FLT_MIN), 0.0f);
  }
  EXPECT_EQ(half(FLT_MIN), 0.0f);
  _mm_setcsr(before);
}
#endif
