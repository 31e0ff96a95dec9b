#pragma once

#include "nodes/lod/TeLodView.h"

/// The view that a selection is made for: it stands still while the camera trembles.
///
/// The eye is *held*: while the true one stays within a radius of where it was when last taken over, the
/// selection is made for the held one, which is told that the true eye may be that much nearer
/// (TeLodView::slack). So a trembling camera switches nothing, and stated errors hold for every eye within
/// the radius. What is in view is always decided by the true planes. In orthographic views, where the eye's
/// place does not matter, nothing is held.
class TeHeldView {
public:
  /// The view that update() would make of one, without taking it over. A radius of 0 holds nothing.
  TeLodView held(const TeLodView& view, double radius) const;
  /// Takes a view over. False if view() is bit for bit as before: what was chosen for it is still right.
  bool update(const TeLodView& view, double radius);
  const TeLodView& view() const { return m_view; }
  /// The next view is taken over as it is, even if it is the same.
  void release() { m_isTaken = false; }

private:
  TeLodView m_view;
  bool m_isTaken = false;
};
