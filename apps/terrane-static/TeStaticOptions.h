#pragma once

#include "apps/common/TeTerrainOptions.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>

/// What terrane-static is asked for besides the common options.
struct TeStaticOptions {
  static constexpr int kMaxBlock = 255;

  TeTerrainOptions terrain;
  int block = 3;        ///< patches a side
  glm::dvec2 center{0}; ///< a point of the middle patch, metres

  double verticalScale = 1;
  bool wireframe = false;
  bool parts = false;
  bool top = false;
  std::optional<double> water; ///< metres
  std::string drape;           ///< PNG picture
  std::string exportFile;      ///< .iv file

  /// Adds the options to a command line, which reads them into this object when it is parsed.
  void addTo(TeCommandLine& commandLine);

private:
  void addView(TeCommandLine& commandLine);
};
