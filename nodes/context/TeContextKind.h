#pragma once

#include "generators/base/TeResult.h"

#include <string_view>

/// Who provides OpenGL.
enum class TeContextKind {
  Window, ///< a window on the display, through SoQt
  Egl,    ///< no display needed; a GPU's device if there is one, else software
  OsMesa, ///< software, no device and no display needed
};

/// "window", "egl" or "osmesa".
const char* teContextName(TeContextKind kind);
/// Error for any other name.
TeResult<TeContextKind> teContextKind(std::string_view name);
