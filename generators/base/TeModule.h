#pragma once

#include "generators/base/TeResult.h"

#include <string>

/// Loads the module `name` (`name`.so in the folder `terrane` beside this library, in the build tree as after
/// installation) on first use and gives the address of one of its symbols. A module stays loaded. Thread-safe.
/// Error: the module is not installed or lacks the symbol; the message names both.
TeResult<void*> teModuleSymbol(const std::string& name, const std::string& symbol);
