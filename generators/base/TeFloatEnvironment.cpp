#include "generators/base/TeFloatEnvironment.h"

#if defined(__SSE2__)
#include <xmmintrin.h>

namespace {
constexpr unsigned kDefaultState = 0x1f80; // all exceptions masked, round to nearest, no FTZ, no DAZ
}

TeFloatEnvironment::TeFloatEnvironment() : m_saved(_mm_getcsr()) { _mm_setcsr(kDefaultState); }
TeFloatEnvironment::~TeFloatEnvironment() { _mm_setcsr(m_saved); }

#else

TeFloatEnvironment::TeFloatEnvironment() {
  std::feholdexcept(&m_saved);
  std::fesetenv(FE_DFL_ENV);
}
TeFloatEnvironment::~TeFloatEnvironment() { std::fesetenv(&m_saved); }

#endif
