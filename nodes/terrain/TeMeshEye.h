#pragma once

#include "nodes/lod/TeLodView.h"

#include <Inventor/SbBox3f.h>
#include <Inventor/SbMatrix.h>
#include <Inventor/SbVec2s.h>
#include <Inventor/SbViewVolume.h>

class SoState;

/// From where the meshes of a terrain are seen: found once for all of them that are drawn with the same
/// camera, viewport and transforms.
class TeMeshEye {
public:
  /// Takes over the camera of the state. False: nothing can be known of it, and everything is to be drawn
  /// with all triangles.
  bool update(SoState* state);
  /// Size on the screen of a vertical deviation anywhere in a box, in pixels, rather too large than too
  /// small.
  double pixels(double deviation, double distance) const { return m_view.pixels(deviation, distance); }
  /// Of the eye from a box, metres; rather too small than too large.
  double distance(const SbBox3f& box) const;

private:
  bool isSame(const SbViewVolume& volume, const SbVec2s& pixels, const SbMatrix& model) const;

  bool m_isKnown = false; ///< what follows is of some camera
  bool m_isGood = false;  ///< and m_view can be used
  SbViewVolume m_volume;
  SbVec2s m_pixels{0, 0};
  SbMatrix m_model;
  TeLodView m_view;
};
