#pragma once

#include "nodes/lod/TeHeldView.h"
#include "nodes/lod/drawing/TeLodRenderer.h"

#include <cstdint>
#include <memory>

/// Who looks at a terrain from one place in one context: the method that chooses for him, what it has chosen,
/// and what he has of it in OpenGL.
class TeLodViewer {
public:
  explicit TeLodViewer(std::unique_ptr<TeLodMethod> method) : m_method(std::move(method)) {}

  const TeLodMethod& method() const { return *m_method; }
  /// Eyes nearer to each other than that are taken for one: half the distance of samples, as nothing that is
  /// drawn is finer; 0 where vertices move smoothly.
  double holdRadius(const TeLodAccuracy& accuracy) const;

  /// Chooses for a view in the field's coordinates, unless all is as before. `slice`: seconds; 0: no limit.
  /// True if it has.
  bool choose(const TeLodView& view, const TeLodAccuracy& accuracy, double slice);
  /// Whether choose() would find all as before.
  bool hasChosen(const TeLodView& view, const TeLodAccuracy& accuracy) const;
  std::uint64_t selections() const { return m_selections; }
  double seconds() const { return m_seconds; } ///< CPU time of the last one

  /// Of the context, which is current; made when it is first asked for.
  TeLodRenderer& renderer(std::uint32_t context);
  /// Gives up what is in OpenGL: now if the context is current, else when it is next.
  void release(bool isCurrent);

  std::uint64_t lastUse = 0;

private:
  std::unique_ptr<TeLodMethod> m_method;
  TeHeldView m_view;
  TeLodAccuracy m_accuracy;
  std::uint64_t m_selections = 0;
  double m_seconds = 0;
  std::shared_ptr<TeLodRenderer> m_renderer;
};
