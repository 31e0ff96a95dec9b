#pragma once

#include "engine/terrain/TeTerrainPiece.h"
#include "nodes/terrain/SoTeTerrainMesh.h"

#include <Inventor/nodes/SoGroup.h>

#include <array>

class TeJob;

/// What TeTerrain knows of a patch that is wanted or was.
struct TeTerrainPatch {
  struct Piece {
    const TeJob* job = nullptr; ///< makes it
    TeNodePtr<SoTeTerrainMesh> node;
    bool made = false; ///< node is there, or there are no triangles
    bool shown = false;
  };

  const TeJob* heightsJob = nullptr;
  bool hasHeights = false;
  std::int64_t retryTick = 0; ///< after a failure: not before this tick
  TeNodePtr<SoGroup> graph;   ///< its pieces that are shown; made with the heights
  bool inScene = false;
  std::array<Piece, 4> pieces;

  Piece& operator[](TeTerrainPiece piece) { return pieces[std::size_t(piece)]; }
};
