#pragma once

#include "apps/common/TeCommandLine.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

/// What terrane-static is asked for besides the common options.
struct TeStaticOptions {
  int block = 3;      ///< patches a side
  int samples = 0;    ///< of a source map; 0 = as suits
  double spacing = 0; ///< metres; 0 = as suits
  std::optional<glm::dvec2> center; ///< of the block, metres

  std::string generator;
  std::vector<std::string> filters;

  std::string dem; ///< elevation file
  std::string verticalUnit = "auto";
  double posts = 0; ///< metres between posts of a file that does not say
  std::string fill = "none";
  std::string outside = "hole";
  bool native = false;

  double verticalScale = 1;
  bool wireframe = false;
  bool parts = false;
  bool top = false;
  std::optional<double> water; ///< height of the water, metres
  std::string drape;           ///< PNG image
  std::string exportFile;      ///< .iv file

  bool listGenerators = false;

  static constexpr int kMaxBlock = 255;

  /// Adds the options to a command line, to be read into this object.
  void addTo(TeCommandLine& commandLine);
  /// What contradicts each other, after parsing.
  TeStatus check() const;

private:
  std::string m_center;
  double m_water = 0;
};
