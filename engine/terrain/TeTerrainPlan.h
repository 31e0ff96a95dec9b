#pragma once

#include "engine/terrain/TeGroundPins.h"
#include "engine/terrain/TePatchBlock.h"
#include "engine/terrain/TeTerrainPiece.h"
#include "engine/terrain/TeTerrainView.h"

#include <vector>

/// Which patches are wanted for a view: the block around the active object, the blocks that it will need
/// soon, and the patches below objects.
class TeTerrainPlan {
public:
  /// From the next update on.
  void setRadius(int radius);

  /// Finds what is wanted now. True if that has changed. Outside the world all stays as it was.
  bool update(const TeLattice& lattice, const TeTerrainView& view);
  /// Of the last update.
  bool blockChanged() const { return m_blockChanged; }
  /// The block has nothing in common with the one before.
  bool jumped() const { return m_jumped; }

  const TePatchBlock& block() const { return m_block; }
  bool inBlock(const TePatchKey& key) const { return m_block.contains(key); }
  /// In the block, or in one that will be needed soon: its pieces are made.
  bool drawable(const TePatchKey& key) const;
  /// The same of all patches that meet in a piece.
  bool inBlock(const TePatchKey& owner, TeTerrainPiece piece) const {
    return tePieceAll(owner, piece, [this](const TePatchKey& key) { return inBlock(key); });
  }
  bool drawable(const TePatchKey& owner, TeTerrainPiece piece) const {
    return tePieceAll(owner, piece, [this](const TePatchKey& key) { return drawable(key); });
  }
  bool wanted(const TePatchKey& key) const { return drawable(key) || m_pins.holds(key); }

  /// visit(key) for what is foreseen and not in the block; some keys may come twice.
  template <class Visit> void forEachAhead(const Visit& visit) const {
    TePatchBlock before = m_block;
    for (const TePatchKey& centre : m_centres) {
      const TePatchBlock next{centre, m_block.radius};
      next.forEachBeyond(before, [&](const TePatchKey& key) {
        if (!m_block.contains(key))
          visit(key);
      });
      before = next;
    }
  }

  const TeGroundPins& pins() const { return m_pins; }
  /// `active`: the object around which the block lies, whose way is foreseen in blocks.
  void place(const TeObject& object, const TeLattice& lattice, bool active = false);
  void forget(const TeObject& object);
  /// True if an update is due though the view may be as before: an object is over other patches, or the
  /// radius is another.
  bool outdated() const { return m_pinsChanged || m_radiusChanged; }

private:
  TePatchBlock m_block;
  std::vector<TePatchKey> m_centres; ///< of the blocks foreseen
  TeGroundPins m_pins;
  int m_radius = 1; ///< of the next block
  bool m_pinsChanged = false;
  bool m_radiusChanged = false;
  bool m_known = false; ///< there was an update
  bool m_blockChanged = false;
  bool m_jumped = false;
};
