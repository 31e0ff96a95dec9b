#pragma once

#include "patchdb/TeMapStore.h"
#include "patchdb/TeMeshBuilder.h"
#include "patchdb/TePatchData.h"
#include "patchdb/TePatchMesh.h"
#include "patchdb/TePatchTree.h"
#include "patchdb/TeSurface.h"
#include "patchdb/TeWorld.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <optional>

/// All known terrain: source maps, patches, seams, each in memory once, found through growing quadtrees.
///
/// Queries use the one surface that is drawn: samples joined by triangles, each cell split along its SW-NE
/// diagonal. They answer *none* where no patch with heights is known or a corner of the cell is missing.
/// The borders of known patches belong to the surface.
/// Not thread-safe except for concurrent const calls.
class TePatchDatabase {
public:
  static constexpr double kMinSpacing = 1e-6; ///< metres
  static constexpr double kMaxSpacing = 1e6;

  /// Error: no chooser, or a spacing outside kMinSpacing .. kMaxSpacing. Whether a source accepts the lattice
  /// is checked when a map is made.
  static TeResult<std::unique_ptr<TePatchDatabase>> create(TeWorld world);

  const TeWorld& world() const { return m_world; }
  const TeLattice& lattice() const { return m_world.lattice; }
  const TeBlendWeights& blendWeights() const { return m_weights; }
  /// Replaces the sources for maps that were never begun; all others keep theirs (see TeMapStore).
  TeStatus setSources(std::shared_ptr<const TeSourceChooser> sources);

  /// The record of a patch by strategy: create it, the nearest coarser one known (null if there is none), or
  /// null. Error for an invalid key.
  TeResult<TePatchData*> lookup(const TePatchKey& key, TeLookup strategy);
  const TePatchData* find(const TePatchKey& key) const { return m_tree.find(key); }
  TePatchData* find(const TePatchKey& key) { return m_tree.find(key); }
  /// Forgets a patch with its seams, and source maps that no other patch holds. False if it was not known.
  bool remove(const TePatchKey& key);
  const TePatchTree& tree() const { return m_tree; }

  /// The source that a map is made with, from now on for ever (see TeMapStore).
  TeResult<TeHeightSourcePtr> mapSource(TeMapKey key) { return m_maps.begin(key); }
  const TeMapStore& maps() const { return m_maps; }
  /// Stores a map that mapSource() has made, or finds it.
  TeSourceMapPtr addMap(TeMapKey key, TeHeightMap heights) { return m_maps.add(key, std::move(heights)); }

  /// Makes (or finds) the source maps of a base patch, all that its heights need (TeNeededMaps); at once.
  /// TePatchJob does it in slices.
  TeStatus prepareBuildMaps(TePatchData& patch);
  /// Blends the patch's heights from its source maps; error: maps missing.
  TeStatus buildHeights(TePatchData& patch);
  /// Both, creating the record: the patch is ready to be drawn. A patch with heights is left as it is.
  /// Error: the key is invalid or not of the base level, or a source failed.
  TeResult<TePatchData*> build(const TePatchKey& key);
  /// Makes a patch of a level above 0 from the base patches below it, which all must have heights, with the
  /// exact deviation of its surface from theirs (TeCoarseHeights). One with heights is made again.
  TeResult<TePatchData*> buildCoarse(const TePatchKey& key);
  /// The patch's inside as a mesh: cells 1 .. n-2 of each side. Error: no heights.
  TeResult<TePatchMesh> patchMesh(const TePatchData& patch) const;
  /// The same in slices; the patch must keep its heights until it is done.
  TeResult<TeMeshBuilder> meshBuilder(const TePatchData& patch) const;
  /// The seam (E, N, W, S) or corner square (NE, NW, SW, SE) in a direction; the same mesh whichever of the
  /// patches that meet there is asked. Error: a patch that takes part has no heights; the message names it.
  TeResult<TePatchMesh> seamMesh(const TePatchData& patch, TeDirection direction) const;
  /// The same, made once and kept by the patches that meet there until one of them changes or goes.
  TeResult<TePatchMeshPtr> seam(TePatchData& patch, TeDirection direction);

  /// Height of the surface; at samples exactly the sample's float. Cost: tens of ns (docs/patch-tree.md).
  std::optional<double> heightAt(glm::dvec2 point) const { return m_surface.heightAt(point); }
  /// Of many points, NaN where there is none: faster than one by one where they are scattered over so many
  /// patches that each waits for memory.
  void heightsAt(const glm::dvec2* points, std::size_t count, double* heights) const {
    m_surface.heightsAt(points, count, heights);
  }
  /// Unit normal of the triangle below or above the point (of one of them on an edge).
  std::optional<glm::dvec3> normalAt(glm::dvec2 point) const;
  /// First hit of the ray with the surface of the patches of a level, from above or below, at a distance
  /// within [0, maxDistance] (in units of the direction's length, which need not be 1; infinity is allowed).
  /// None also for an origin or direction that is not finite, and a direction of length 0. Visits known
  /// patches only.
  std::optional<TeRayHit> intersect(glm::dvec3 origin, glm::dvec3 direction, double maxDistance,
                                    int level = 0) const;

  /// Height from the finest known patch, and how far the base level may differ from it.
  std::optional<TeSurfacePoint> surfaceAt(glm::dvec2 point) const;
  /// The same from the patch of a level; none if that is not known, though others may be.
  std::optional<TeSurfacePoint> surfaceAt(glm::dvec2 point, int level) const;

private:
  explicit TePatchDatabase(TeWorld world)
      : m_world(std::move(world)), m_weights(m_world.lattice.cells(), m_world.blending),
        m_maps(m_world.sources) {}

  TeWorld m_world;
  TeBlendWeights m_weights;
  TeMapStore m_maps;
  TePatchTree m_tree;
  TeSurface m_surface{m_world.lattice, m_tree};
};
