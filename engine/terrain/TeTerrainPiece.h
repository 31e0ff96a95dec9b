#pragma once

#include "patchdb/TePatchKey.h"

#include <array>
#include <vector>

/// The pieces of the surface that a patch owns: its inside, the seams to the east and north, and the corner
/// square to the north-east. A piece can be made once all patches that meet in it have heights.
enum class TeTerrainPiece { Inside, East, North, NorthEast };

inline constexpr std::array<TeTerrainPiece, 4> kTeTerrainPieces = {
    TeTerrainPiece::Inside, TeTerrainPiece::East, TeTerrainPiece::North, TeTerrainPiece::NorthEast};

/// Seen from the owner; of all pieces but Inside.
constexpr TeDirection tePieceDirection(TeTerrainPiece piece) {
  return piece == TeTerrainPiece::East    ? TeDirection::East
         : piece == TeTerrainPiece::North ? TeDirection::North
                                          : TeDirection::NorthEast;
}

/// True if `test(key)` holds for all patches that meet in a piece.
template <class Test> bool tePieceAll(const TePatchKey& owner, TeTerrainPiece piece, const Test& test) {
  const std::int64_t east = piece == TeTerrainPiece::East || piece == TeTerrainPiece::NorthEast ? 1 : 0;
  const std::int64_t north = piece == TeTerrainPiece::North || piece == TeTerrainPiece::NorthEast ? 1 : 0;
  for (std::int64_t y = 0; y <= north; ++y)
    for (std::int64_t x = 0; x <= east; ++x)
      if (!test(TePatchKey{owner.x + x, owner.y + y, owner.level}))
        return false;
  return true;
}

/// visit(owner, piece) for the nine pieces that a patch takes part in.
template <class Visit> void tePiecesAround(const TePatchKey& key, const Visit& visit) {
  const TePatchKey west{key.x - 1, key.y, key.level};
  const TePatchKey south{key.x, key.y - 1, key.level};
  const TePatchKey southWest{key.x - 1, key.y - 1, key.level};
  for (const TeTerrainPiece piece : kTeTerrainPieces)
    visit(key, piece);
  visit(west, TeTerrainPiece::East);
  visit(west, TeTerrainPiece::NorthEast);
  visit(south, TeTerrainPiece::North);
  visit(south, TeTerrainPiece::NorthEast);
  visit(southWest, TeTerrainPiece::NorthEast);
}
