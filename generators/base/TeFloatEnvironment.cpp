#include "generators/base/TeFloatEnvironment.h"

#if defined(__SSE2__)
#include <xmmintrin.h>

namespace {
constexpr unsigned kDefaultState = 0x1f80; // all exceptions masked, round to nearest, no FTZ, no DAZ
}

TeFloatEnvironment::TeFloatEnvironment() : m_saved(_mm_getcsr()) { _mm_setcsr(kDefaultState); }
TeFloatEnvironment::~TeFloatEnvironment() { _mm_setcsr(m_saved); }

#else
#include <cfenv>

TeFloatEnvironment::TeFloatEnvironment() : m_saved(unsigned(std::fegetround())) {
  std::fesetround(FE_TONEAREST);
}
TeFloatEnvironment::~TeFloatEnvironment() { std::fesetround(int(m_saved)); }
#endif
