#pragma once

#include "nodes/seamless/TeSeamlessSelector.h"

/// What one frame's view asks of sides: how detailed they are to be drawn, and whether their patches are to
/// be divided. Lengths are in samples' distances.
///
/// Precision: e = p·l / d with the side's length l and distance d, where heights differ from the eye's by at
/// least the least difference of the whole terrain; patches with a side of e > 1 are divided. Without
/// perspective d is that at which a camera of 1000 pixels focal length sees as many pixels a metre, the same
/// for all sides, which so fit with any p.
/// Error: a side's own static errors (TeSideBounds) over the distances to their boxes.
/// Either way what a patch does follows from its own sides, and neighbours fit: docs/seamless-patches.md.
class TeSideMetric {
public:
  /// `bounds` may be null if accuracy asks for precision. `coarsening` >= 1 lowers the accuracy.
  TeSideMetric(const TeSeamlessLayout& layout, const TeSeamlessBounds* bounds,
               const TeSeamlessPlacement& placement, const TeLodView& view,
               const TeSeamlessAccuracy& accuracy, double coarsening);

  /// How much a patch is to be divided: for the sake of that of its sides which asks for most.
  double division(int level, std::int32_t x, std::int32_t y) const;
  /// A patch is divided if its division() is above this.
  double threshold(int level) const;
  /// A side as the view sees it.
  struct SeenSide {
    double length = 0;
    double squaredDistance = 0;    ///< to the side itself
    const float* errors = nullptr; ///< by resolution index; null without bounds
    double tilesDistance = 0;      ///< to all that is drawn at the side's resolution
  };
  SeenSide see(const TeSideKey& side) const;
  /// Detail that a side asks for by itself: 0 .. levels - 1, whole without geomorphing.
  float detail(const SeenSide& side) const;
  /// Least detail of all sides of a patch with that division(): rises to levels - 1 at the
  /// threshold, so that a patch about to be divided has the vertices of its children.
  float detailBefore(double division, int level) const;
  /// False where distances alone ensure what detailBefore() asks of a patch's neighbours.
  bool asksNeighbours() const { return m_byError || m_geomorph; }

  /// Screen error of a side at a whole resolution index, with the rounding of heights, pixels; needs bounds.
  double errorPixels(const SeenSide& side, int index) const;
  /// Square of the document's p with which the side would be drawn at that index or higher.
  double squaredPrecision(const SeenSide& side, int index) const;

private:
  double squaredDistance(const TeSideKey& side) const;
  double distanceToBox(const TeSideKey& side, double across, double along, TeHeightRange range) const;
  double divisionByError(const TeSideKey& side) const;
  double wantedErrors(const SeenSide& side, int index) const; ///< its error, 1 if it is the wanted one

  const TeSeamlessLayout& m_layout;
  const TeSeamlessBounds* m_bounds;
  bool m_byError;
  bool m_geomorph;
  bool m_perspective;
  glm::dvec3 m_eye;     ///< in samples' distances from the corner
  double m_slack;       ///< the true eye may be nearer by this
  double m_heightScale; ///< samples' distances a unit of height
  double m_precision;
  double m_rounding;     ///< of heights
  double m_squaredRise;  ///< of the eye above or below the range of all heights
  double m_flatDistance; ///< stands for all distances without perspective
  double m_pixels;       ///< of one unit of height at a distance of one sample's
  double m_errorScale;   ///< the same, in wanted errors
};
