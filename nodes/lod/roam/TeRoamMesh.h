#pragma once

#include "nodes/lod/roam/TeRoamMetric.h"
#include "nodes/lod/roam/TeRoamNodes.h"
#include "nodes/lod/roam/TeRoamQueue.h"
#include "nodes/lod/roam/TeRoamScreen.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

/// A mesh of a triangle quadtree between views: its triangles, their priorities, and the queues of what to
/// split and what to merge next. docs/roam.md.
///
/// Always: the neighbours of a split triangle exist. So levels differ by one at most across an edge, and what
/// is drawn (TeRoamFan) fits. split() keeps that by splitting coarser neighbours first, merge() by its
/// condition.
///
/// The split queue holds every leaf above the deepest level, the merge queue every split triangle that no
/// other one needs (locks 0).
class TeRoamMesh {
public:
  /// Without `keepsMerges` the merge queue stays empty (the document's simplified form). A metric of
  /// variances needs bounds that have them.
  TeRoamMesh(std::shared_ptr<const TeRoamBounds> bounds, TeRoamMetric metric, bool keepsMerges);

  /// The base alone; a view must follow.
  void reset();
  /// All priorities anew; after much was merged, the rest moves together first, so that a frame costs what
  /// its mesh does, whatever came before. `least`: in pixels, of triangles in view, whatever their error.
  /// Cost: 5 to 7 ns a triangle.
  void setView(const TeLodView& view, float least);

  /// The leaf, after the coarser neighbours that have to be. Returns how many triangles were split. Cost: 0.2
  /// us each.
  int split(std::int32_t leaf);
  /// A triangle of the merge queue.
  void merge(std::int32_t node);
  /// No fewer triangles than a split adds to those drawn: six for each triangle that is split, of which three
  /// are its children and three the halves of its neighbours.
  std::int64_t growth(std::int32_t leaf) const;

  const TeRoamNodes& nodes() const { return m_nodes; }
  const TeRoamQueue& splits() const { return m_splits; }
  const TeRoamQueue& merges() const { return m_merges; }
  float priority(std::int32_t node) const { return priorities()[node]; }
  bool isSeen(std::int32_t node) const { return m_screen[std::size_t(node)] >= 0; }
  /// 1 for a leaf in view, else 0; without a branch.
  int isShown(std::int32_t node) const { return int(m_fans[std::size_t(node)] != 0) & int(isSeen(node)); }
  /// Triangles that a leaf is drawn with; 0 if it is none.
  int fan(std::int32_t node) const { return m_fans[std::size_t(node)]; }

  /// A metric's number for an error of one pixel.
  double unitsPerPixel() const { return m_unitsPerPixel; }
  /// Pixels by which no sample in view deviates; infinite if the eye is in the box of a triangle with an
  /// error.
  double errorBound() const;
  std::int64_t drawn() const { return m_drawn; }   ///< triangles of the leaves in view
  std::int64_t culled() const { return m_culled; } ///< nodes not in view, when the view was set
  /// Another number when what is drawn is another mesh.
  std::uint64_t version() const { return m_version; }
  std::size_t bytes() const;

private:
  void compact();
  const float* priorities() const {
    return m_metric == TeRoamMetric::ScreenError ? m_screen.data() : m_document.data();
  }
  void countDrawn();
  void measure(std::int32_t first, std::size_t count);
  void applyFormula(std::int32_t first, float most);
  void applyFormulaBelow(std::int32_t node);
  float formula(std::int32_t node) const;
  void collectSplits(std::int32_t leaf) const;
  void setFan(std::int32_t node);
  void lockNeeded(std::int32_t node, int change);
  void changeLocks(std::int32_t node, int change);

  TeRoamMetric m_metric;
  bool m_keepsMerges;
  TeRoamNodes m_nodes;
  TeRoamQueue m_splits{TeRoamQueue::Order::MostImportantFirst};
  TeRoamQueue m_merges{TeRoamQueue::Order::LeastImportantFirst};
  std::optional<TeRoamScreen> m_view;
  TeLodView m_camera;
  float m_least = 0;
  double m_unitsPerPixel = 1;

  // By node.
  std::vector<float> m_screen;   ///< pixels; -1 out of view
  std::vector<float> m_document; ///< of a metric of variances
  std::vector<std::uint8_t> m_fans;
  std::vector<std::uint8_t> m_shown; ///< was in view when the view was set

  mutable std::vector<std::int32_t> m_collected; ///< of growth()

  std::int64_t m_drawn = 0;
  std::int64_t m_culled = 0;
  std::uint64_t m_version = 0;
};
