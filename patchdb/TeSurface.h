#pragma once

#include "patchdb/TePatchTree.h"
#include "patchdb/TeRayHit.h"
#include "patchdb/TeSurfaceCell.h"
#include "patchdb/TeSurfacePoint.h"

#include <atomic>
#include <cmath>
#include <optional>

/// Queries on the one surface of all known patches; see TePatchDatabase, which holds one. Looks at the tree
/// and the lattice that it was made with. Const calls may run on several threads.
class TeSurface {
public:
  TeSurface(const TeLattice& lattice, const TePatchTree& tree)
      : m_lattice(&lattice), m_tree(&tree), m_perMetre(1 / lattice.spacing()),
        m_halfCell(0.5 * lattice.spacing()), m_perCells(1 / double(lattice.cells())),
        m_halfSide(0.5 * double(lattice.cells())),
        m_limit(lattice.spacing() * double(lattice.cells()) * double(TeLattice::kMaxKey)),
        m_cells(lattice.cells()) {}

  std::optional<double> heightAt(glm::dvec2 point) const {
    double height = 0;
    return findHeight(point, height) ? std::optional<double>(height) : std::nullopt;
  }
  void heightsAt(const glm::dvec2* points, std::size_t count, double* heights) const;
  std::optional<glm::dvec3> normalAt(glm::dvec2 point) const;
  std::optional<TeSurfacePoint> pointAt(glm::dvec2 point) const;
  std::optional<TeSurfacePoint> pointAt(glm::dvec2 point, int level) const;
  std::optional<TeRayHit> intersect(glm::dvec3 origin, glm::dvec3 direction, double maxDistance,
                                    int level) const;

  /// To be called before a patch is removed.
  void forget() { m_last = nullptr; }

private:
  /// Of its own: GCC returns an optional number through memory, in parts that it then waits for.
  bool findHeight(glm::dvec2 point, double& height) const;
  /// A point in a complete cell of a patch.
  struct Place {
    const TePatchData* patch = nullptr;
    TeSurfaceCell cell;
    double u = 0;
    double v = 0;
  };
  static constexpr int kFinest = -1; ///< in place of a level: of what is known there
  bool locate(glm::dvec2 point, int level, Place& place) const;
  /// The bits of TeLattice::position(), within reach of the optimiser.
  double position(std::int64_t sample) const { return double(2 * sample - m_cells) * m_halfCell; }
  std::int64_t sampleBelow(double position, double& fraction) const;
  bool locateInCell(std::int64_t sampleX, std::int64_t sampleY, int level, Place& place) const;
  std::int64_t patchAt(std::int64_t sample, std::int64_t& within) const;
  const TePatchData* basePatchOf(std::int64_t& x, std::int64_t& y) const;
  const TePatchData* patchOf(std::int64_t sampleX, std::int64_t sampleY) const;
  const TePatchData* patchOf(std::int64_t sampleX, std::int64_t sampleY, int level) const;

  /// Points of the world. Written so that a NaN is none.
  bool holds(glm::dvec2 point) const { return std::fabs(point.x) < m_limit && std::fabs(point.y) < m_limit; }

  const TeLattice* m_lattice;
  const TePatchTree* m_tree;
  double m_perMetre;
  double m_halfCell;
  double m_perCells;
  double m_halfSide; ///< of a patch, in cells
  double m_limit;    ///< metres from the origin to the rim of the world
  std::int64_t m_cells;
  mutable std::atomic<const TePatchData*> m_last{nullptr}; ///< answered last; the next query is often near
};
