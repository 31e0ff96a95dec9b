#pragma once

#include "apps/common/TeCommandLine.h"

#include <string>

/// What `terrane-bake synth` is asked for.
struct TeSynthOptions {
  std::string output;
  int side = 16385; ///< samples
  std::string from; ///< elevation file; empty = of noise
  bool force = false;

  /// Adds the command with its options, which are read into this object.
  CLI::App* addTo(TeCommandLine& commandLine);
};
