#pragma once

#include "apps/common/TeCommandLine.h"

#include <optional>
#include <string>
#include <vector>

/// What `terrane-bake mipmaps` is asked for.
struct TeMipmapsOptions {
  std::string input;
  std::string output;

  bool raw = false; ///< headerless, whatever the file is called
  std::string rawOrder = "little";
  std::string rawSamples = "unsigned";
  int band = 0; ///< 0 = heights from the first, or colours from three or four

  std::vector<double> noData;
  std::optional<double> fill; ///< stored value
  bool resample = false;

  double posts = 0; ///< metres between samples of the input; 0 = as it says
  std::string verticalUnit = "auto";

  bool force = false;
  bool bounds = true;
  int minResolution = 16;
  int levels = 3;

  /// Adds the command with its options, which are read into this object.
  CLI::App* addTo(TeCommandLine& commandLine);
  bool isRaw() const;
  /// Of all that samples depend on besides the input.
  std::uint64_t hash() const;
};
