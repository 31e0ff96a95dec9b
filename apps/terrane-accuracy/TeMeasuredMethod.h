#pragma once

#include "generators/base/TeResult.h"
#include "nodes/lod/TeLodView.h"
#include "nodes/seamless/TeSeamlessMesh.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class SoNode;

/// How accurate a method is to be: a wanted screen error, or the method's own dial.
struct TeDial {
  double pixels = 0; ///< wanted error; if 0 the dial holds
  double own = 0;    ///< in the unit of the method
};

/// What one selection came to.
struct TeSelected {
  std::int64_t triangles = 0;
  std::int64_t visited = 0; ///< patches, nodes … of the method's own structure
  std::int64_t parts = 0;   ///< of those drawn
  std::int64_t drawCalls = 0;
  std::int64_t uploadBytes = 0; ///< sent for this frame
  double boundPixels = 0;       ///< the error that the method itself promises
  double dial = 0;              ///< its own dial, or what it would be for the wanted error
};

/// A LOD method as it is measured: built over one terrain, then asked view by view.
class TeMeasuredMethod {
public:
  virtual ~TeMeasuredMethod() = default;

  virtual const std::string& name() const = 0;
  /// Of main memory and OpenGL's, samples included.
  virtual double bytesPerSample() const = 0;
  /// All that is decided for a frame before anything is drawn: what is timed as selection.
  virtual void select(const TeLodView& view, const TeDial& dial) = 0;
  /// What the last select() came to, and the triangles that it draws.
  virtual TeSelected selected() const = 0;
  virtual void appendMesh(std::vector<TeSeamlessMesh::Triangle>& triangles) const = 0;
  /// Draws the terrain so accurately, choosing for itself by the scene's camera. The same node each time.
  virtual SoNode* node(const TeDial& dial) = 0;
};
