#pragma once

#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/roam/TeRoamMesh.h"

#include <memory>
#include <vector>

/// ROAM (Duchaineau et al. 1997) on a triangle quadtree (Markuziová 2006): a mesh that is kept from frame to
/// frame and changed by splits and merges of triangles, the most needed first; docs/roam.md. The dial is the
/// document's number of triangles; those drawn, in view, are from 97 % of it to all of it wherever errors
/// remain.
///
/// With a wanted error (and a budget that allows it) the mesh is the same whatever views came before: the
/// smallest one whose triangles have no larger priority.
///
/// A unit of an allowance is a triangle split or merged; priorities are computed in any case.
class TeRoamLod final : public TeLodMethod {
public:
  struct Settings {
    TeRoamMetric metric = TeRoamMetric::ScreenError;
    /// The document's form for small terrain: no merges, each view starts from the base.
    bool splitOnly = false;
  };

  static std::unique_ptr<TeRoamLod> create(TeLodFieldPtr field, const Settings& settings);
  static std::unique_ptr<TeRoamLod> create(TeLodFieldPtr field) {
    return create(std::move(field), Settings());
  }
  /// Over bounds that others use, too; with variances where the metric is one of variances.
  TeRoamLod(std::shared_ptr<const TeRoamBounds> bounds, TeLodFieldPtr field, const Settings& settings);

  std::string name() const override { return "roam"; }
  const TeLodDial& dial() const override { return m_dial; }
  double bytesPerSample() const override;
  /// Cost: 10 ns a triangle.
  void appendPart(std::size_t part, TeLodMesh& mesh) const override;

  const TeRoamMesh& mesh() const { return m_mesh; }

protected:
  void choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
              TeLodSelection& selection) override;
  bool coarsens() const override { return false; }

private:
  /// What a selection goes after.
  struct Goal {
    double wanted = 0;          ///< no triangle is more important, in the metric's unit
    std::int64_t triangles = 0; ///< drawn at most
    bool fills = true;          ///< splits while there is room for triangles
  };
  enum class Step { Split, Merge, Done };

  bool continues(const TeLodView& view, const TeLodAccuracy& accuracy) const;
  Step next(const Goal& goal) const;
  bool refine(const Goal& goal, TeAllowance& allowance, TeLodSelection& selection);

  std::shared_ptr<const TeRoamBounds> m_bounds;
  Settings m_settings;
  TeLodDial m_dial;
  TeRoamMesh m_mesh;
  // Of the part that is made.
  mutable std::vector<std::int32_t> m_leaves;
  mutable std::vector<std::uint8_t> m_marks;    ///< by vertex of the mesh: it is used
  mutable std::vector<std::uint32_t> m_indices; ///< by vertex of the mesh

  // The last selection.
  bool m_isComplete = true;
  bool m_isFirst = true;
  TeLodView m_view;
  TeLodAccuracy m_accuracy;
  float m_floor = 0; ///< the most important triangle that was merged
  bool m_mergesNext = false;
};
