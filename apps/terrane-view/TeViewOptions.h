#pragma once

#include "apps/common/TeDemReading.h"
#include "generators/base/TeResult.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

/// What terrane-view is asked for besides the common options.
struct TeViewOptions {
  static constexpr double kMaxSize = 1e8;  ///< metres
  static constexpr double kMaxSpeed = 1e6; ///< m/s
  static constexpr int kDetails = 4;

  // One of these three.
  std::string scene;    ///< Inventor file
  std::string dem;      ///< elevation file
  std::string clipmaps; ///< NAME of NAME_0.raw, NAME_1.raw, …

  TeDemReading reading;
  int resolution = 0;     ///< cells a side that the elevation file is drawn with; 0 = about its own
  double side = 0;        ///< metres a side of the terrain; 0 = as the file or pyramid says
  double heightScale = 0; ///< stretches metres; of a pyramid metres a step; 0 = as the file or pyramid says

  std::string method; ///< LOD method that draws an elevation file; empty = Seamless Patches on the GPU
  int clipSize = 513;
  int patchResolution = 16; ///< the lowest
  int levels = 3;
  std::optional<double> precision;
  std::optional<double> pixelError;
  double fps = 0; ///< wanted frames a second, for which the error is chosen; 0 = none
  bool geomorph = false;
  bool classic = false;
  std::string colouring;            ///< plain, texture, detail or height; empty = as suits
  std::string texture;              ///< picture; empty = none
  std::string colours;              ///< NAME of a pyramid of colours in place of the texture
  std::string mask;                 ///< picture
  std::vector<std::string> details; ///< pictures, kDetails of them

  bool wireframe = false;
  bool secondCamera = false;
  bool statistics = false;
  bool sky = false;
  bool haze = false;
  std::string up; ///< y, z, or empty = as the scene's camera has it
  std::optional<glm::dvec3> eye;
  std::optional<glm::dvec3> look; ///< the point that is looked at

  std::string path;            ///< built-in or a file; empty = the user flies
  std::optional<double> speed; ///< m/s on a path
  std::optional<double> altitude;
  std::string screenshots = "."; ///< folder

  /// Adds the options to a command line, which reads them into this object when it is parsed.
  void addTo(TeCommandLine& commandLine);
  /// What contradicts what; after parsing.
  TeStatus check() const;

private:
  void addInput(TeCommandLine& commandLine);
  void addTerrain(TeCommandLine& commandLine);
  void addView(TeCommandLine& commandLine);
  void addFlight(TeCommandLine& commandLine);
};
