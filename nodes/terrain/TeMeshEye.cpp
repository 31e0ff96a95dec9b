#include "nodes/terrain/TeMeshEye.h"

#include "nodes/lod/TeCameraView.h"

#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoViewVolumeElement.h>
#include <Inventor/elements/SoViewportRegionElement.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace {

/// Of the eye's distance from the meshes' own origin: what single precision may make of it.
constexpr double kRounding = 1e-6;

} // namespace

bool TeMeshEye::isSame(const SbViewVolume& volume, const SbVec2s& pixels, const SbMatrix& model) const {
  return m_isKnown && pixels == m_pixels && volume.getProjectionPoint() == m_volume.getProjectionPoint() &&
         volume.getProjectionDirection() == m_volume.getProjectionDirection() &&
         volume.getWidth() == m_volume.getWidth() && volume.getHeight() == m_volume.getHeight() &&
         volume.getNearDist() == m_volume.getNearDist() &&
         volume.getProjectionType() == m_volume.getProjectionType() && model == m_model;
}

bool TeMeshEye::update(SoState* state) {
  if (!TeCameraView::hasCamera(state))
    return false;
  const SbViewVolume& volume = SoViewVolumeElement::get(state);
  const SbVec2s& pixels = SoViewportRegionElement::get(state).getViewportSizePixels();
  const SbMatrix& model = SoModelMatrixElement::get(state);
  if (!isSame(volume, pixels, model)) {
    m_isKnown = true;
    m_volume = volume;
    m_pixels = pixels;
    m_model = model;
    const std::optional<TeLodView> view = TeCameraView::create(volume, pixels, model);
    m_isGood = view.has_value();
    if (view)
      m_view = *view;
  }
  return m_isGood;
}

double TeMeshEye::distance(const SbBox3f& box) const {
  glm::dvec3 way(0);
  for (int axis = 0; axis < 3; ++axis)
    way[axis] = std::max(
        {double(box.getMin()[axis]) - m_view.eye[axis], m_view.eye[axis] - double(box.getMax()[axis]), 0.0});
  return std::max(0.0, glm::length(way) - m_view.slack - kRounding * glm::length(m_view.eye));
}
