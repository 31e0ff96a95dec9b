#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/clipmap/SoTeClipmap.h"
#include "nodes/seamless/TeSeamlessTerrain.h"

#include <glm/vec3.hpp>

#include <memory>
#include <string>

/// Heights in memory for Seamless Patches, and what they say of themselves.
struct TeSeamlessContent {
  TeSeamlessTerrainPtr terrain;
  TeNodePtr<SoTeClipmap> clipmap; ///< that the heights come from; null: none
  /// Why its errors are not known; empty if they are, or there is no clipmap.
  std::string boundsError;
  bool isRaw = false; ///< heights are 16 bit numbers; else metres
  double spacing = 1; ///< metres between samples, if the user does not say

  bool isFlat() const { return !terrain->map && !clipmap; }

  /// How the tree of patches is to be; resolution 0: as many cells as the heights have.
  struct Sizes {
    int resolution = 4096;
    int minPatchResolution = 16;
    int levels = 3;
  };

  /// Where it lies: extents in x and y (0: as `spacing` says) and height of the largest 16 bit number, around
  /// `middle`. Error: unequal extents, one of them out of range, not finite.
  TeResult<TeSeamlessPlacement> place(const glm::dvec3& size, const glm::dvec3& middle) const;

  /// Error: sizes that make no TeSeamlessLayout.
  static TeResult<TeSeamlessContent> flat(const Sizes& sizes);
  /// Error: likewise; a map that is no square of resolution + 1 samples or misses some.
  static TeResult<TeSeamlessContent> ofMap(std::shared_ptr<const TeHeightMap> map, const Sizes& sizes);
  /// Error: likewise, and those of TeSeamlessHeightFile. `verticalUnit` as teVerticalUnit() reads it.
  static TeResult<TeSeamlessContent> ofFile(const std::string& path, const std::string& verticalUnit,
                                            const Sizes& sizes);
  /// Error: likewise; a node that is no SoTeClipmap of heights, or its error. `isReported`: the node has said
  /// it.
  static TeResult<TeSeamlessContent> ofClipmap(SoNode* node, const Sizes& sizes, bool& isReported);
};
