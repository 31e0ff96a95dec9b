#pragma once

#include "nodes/TeWorldRect.h"
#include "patchdb/TePatchDatabase.h"

#include <functional>
#include <memory>
#include <optional>

/// A square block of patches of a world, with the seams between them: plain data, no Coin.
///
/// The outermost strip of cells all around is not drawn: its normals need patches that the block does not
/// have. What is drawn is drawnRect().
class TeStaticBlock {
public:
  /// Heights of 128 MiB. Source maps that have to be blended take four times as much memory for a block of
  /// many patches, sixteen times for a single patch.
  static constexpr std::int64_t kMaxSamples = std::int64_t(1) << 25;

  /// Called with the number of patches that are done.
  using Progress = std::function<void(int done, int total)>;

  /// Makes patches × patches patches: an odd number around the patch that contains the centre, an even one
  /// around the patch corner nearest to it. Error: a number of patches below 1, more than kMaxSamples
  /// samples, a centre that is not finite or too far out, a source that fails.
  static TeResult<TeStaticBlock> build(TeWorld world, glm::dvec2 centre, int patches,
                                       const Progress& progress = {});

  const TePatchDatabase& database() const { return *m_database; }
  const TeLattice& lattice() const { return m_database->lattice(); }
  int patches() const { return m_patches; }
  /// The patch in the south-west.
  const TePatchKey& firstKey() const { return m_first; }
  /// Middle of the block.
  glm::dvec2 centre() const;
  /// All patches, and what is drawn of them.
  TeWorldRect rect() const { return inset(0); }
  TeWorldRect drawnRect() const { return inset(1); }
  /// Heights that are not missing; all 0 if all are. Samples on the border of two patches count twice.
  float minimum() const { return m_minimum; }
  float maximum() const { return m_maximum; }
  float mean() const { return m_mean; }

  /// Gives the meshes of all patches, seams and corner squares that have triangles, one by one, row by row
  /// from the south-west.
  TeStatus forEachPiece(const std::function<void(const TePatchMesh&)>& use) const;
  /// First hit of a ray with what is drawn, at a distance in [0, infinity), as TePatchDatabase::intersect.
  std::optional<TeRayHit> intersect(glm::dvec3 origin, glm::dvec3 direction) const;

private:
  TeStaticBlock() = default;
  TeWorldRect inset(int cells) const;

  std::unique_ptr<TePatchDatabase> m_database;
  TePatchKey m_first;
  int m_patches = 0;
  float m_minimum = 0;
  float m_maximum = 0;
  float m_mean = 0;
};
