#pragma once

#include <cstdint>
#include <string>

/// The options that every application has.
struct TeCommonOptions {
  std::string context;   ///< "window", "egl" or "osmesa"
  std::string offscreen; ///< PNG file for the last frame; empty = none
  int width = 1024;      ///< pixels, 1 .. kMaxSide
  int height = 768;
  int frames = 0; ///< 0 = one without a window, until it is closed with one
  double dt = 0;  ///< seconds a frame; 0 = as time passes
  std::uint64_t seed = 0;
  std::string report; ///< JSON file; empty = none
  bool quiet = false;

  static constexpr int kMaxSide = 8192;
};
