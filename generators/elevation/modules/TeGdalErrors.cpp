#include "generators/elevation/modules/TeGdalErrors.h"

#include <cpl_error.h>

namespace {

void CPL_STDCALL collect(CPLErr severity, CPLErrorNum, const char* message) {
  if (severity >= CE_Failure)
    static_cast<TeGdalErrors*>(CPLGetErrorHandlerUserData())->add(message);
}

constexpr std::size_t kLongest = 200;

} // namespace

TeGdalErrors::TeGdalErrors() { CPLPushErrorHandlerEx(&collect, this); }
TeGdalErrors::~TeGdalErrors() { CPLPopErrorHandler(); }

void TeGdalErrors::add(const char* message) {
  if (failed())
    return;
  for (const char* c = message; *c && m_first.size() < kLongest; ++c)
    m_first += static_cast<unsigned char>(*c) < ' ' ? ' ' : *c;
  if (m_first.empty())
    m_first = "unknown failure";
}
