#pragma once

#include "nodes/TeNodePtr.h"
#include "patchdb/TePatchData.h"

#include <Inventor/SbBasic.h>
#include <Inventor/SbVec2d.h>
#include <Inventor/nodes/SoSeparator.h>

#include <array>

class TeEngine;

/// A patch of a TeEngine in the words of document 002: first its four source maps, then its heights, then its
/// scene graphs. Belongs to the engine; its calls report errors through TeEngine::lastError().
///
/// A patch's graph covers its inside; the strips where patches meet are seams, which need the neighbours'
/// heights too. All of them together tile the plane.
class TePatch {
public:
  /// Of a seam, seen from the patch; north is +y.
  enum Direction { EAST, NORTH_EAST, NORTH, NORTH_WEST, WEST, SOUTH_WEST, SOUTH, SOUTH_EAST };

  TePatch(const TePatch&) = delete;
  TePatch& operator=(const TePatch&) = delete;

  const TePatchKey& getKey() const { return m_data.key(); }
  /// World coordinates, metres.
  SbVec2d getCentre() const;
  /// The plain data: heights, source maps, neighbours.
  const TePatchData& getData() const { return m_data; }

  /// Finds or makes the four source maps, with the generator's parameters as they are now; at once. FALSE: a
  /// map cannot be made.
  SbBool prepareBuildMaps();
  /// Blends the heights from the source maps, once. FALSE: prepareBuildMaps() has not succeeded before.
  SbBool buildHMapFromBuildMaps();
  /// The inside as standard Coin nodes, made at the first call. The engine keeps it, and so does every scene
  /// that it is added to. NULL: the heights are not built.
  SoSeparator* getPatchGraph();
  /// The seam (EAST, NORTH, WEST, SOUTH) or corner square (the others); the patches that meet there get the
  /// same node. NULL: one of them does not exist or has no heights.
  SoSeparator* getSeamGraph(Direction direction);

private:
  friend class TeEngine;
  TePatch(TeEngine& engine, TePatchData& data);

  TeEngine& m_engine;
  TePatchData& m_data;
  TeNodePtr<SoSeparator> m_graph;
  /// Of the seams to the east, north-east and north; the others are kept by neighbours.
  std::array<TeNodePtr<SoSeparator>, 3> m_seamGraphs;
};
