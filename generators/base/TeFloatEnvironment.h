#pragma once

#include <cfenv>

/// Sets the floating-point state on which bit-equality rests for the life of the object: round to nearest,
/// denormals kept (FTZ and DAZ off), exceptions masked; restores the caller's state afterwards. Every slice
/// of a job opens one, so a host that changed the state (as some audio and plug-in hosts do) changes no bit
/// of the terrain. Cost: some nanoseconds.
class TeFloatEnvironment {
public:
  TeFloatEnvironment();
  ~TeFloatEnvironment();
  TeFloatEnvironment(const TeFloatEnvironment&) = delete;
  TeFloatEnvironment& operator=(const TeFloatEnvironment&) = delete;

private:
#if defined(__SSE2__)
  unsigned m_saved;
#else
  std::fenv_t m_saved;
#endif
};
