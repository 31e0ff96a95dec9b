#include "nodes/lod/TeCameraView.h"

#include "nodes/TeCoinVectors.h"

#include <Inventor/SbDPMatrix.h>
#include <Inventor/SbDPViewVolume.h>
#include <Inventor/SbMatrix.h>
#include <Inventor/SbVec2s.h>
#include <Inventor/SbVec3d.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoViewVolumeElement.h>
#include <Inventor/elements/SoViewportRegionElement.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoCamera.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// Of the eye's distance from the origin: planes are moved outward by as much as the single precision of
/// what is drawn may move the picture.
constexpr double kPlaneMargin = 1e-6;

SbDPMatrix toDouble(const SbMatrix& matrix) {
  SbDPMatrix result;
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++)
      result[i][j] = double(matrix[i][j]);
  }
  return result;
}

/// The length of the longest image of a unit vector; m·v is the image. Eigenvalue of a symmetric matrix by
/// Smith 1961, who finds the largest to nearly all digits, but not the others.
double longestImage(const glm::dmat3& m) {
  const glm::dmat3 squares = glm::transpose(m) * m;
  const double mean = (squares[0][0] + squares[1][1] + squares[2][2]) / 3;
  const glm::dmat3 rest = squares - mean * glm::dmat3(1.0);
  double sum = 0;
  for (int i = 0; i < 3; i++)
    sum += glm::dot(rest[i], rest[i]);
  const double spread = std::sqrt(sum / 6);
  if (!(spread > 1e-14 * mean))
    return std::sqrt(mean);
  const double cosine = std::clamp(glm::determinant(rest / spread) / 2, -1.0, 1.0);
  return std::sqrt(mean + 2 * spread * std::cos(std::acos(cosine) / 3));
}

bool isFinite(const TeLodView& view) {
  double sum = view.eye.x + view.eye.y + view.eye.z;
  for (const glm::dvec4& plane : view.planes)
    sum += plane.x + plane.y + plane.z + plane.w;
  return std::isfinite(sum) && view.focal > 0 && std::isfinite(view.focal);
}

} // namespace

std::optional<TeLodView> TeCameraView::create(const SbViewVolume& volume, const SbVec2s& pixels,
                                              const SbMatrix& model) {
  const SbDPMatrix place = toDouble(model);
  glm::dmat3 axes; // columns: images of the shape's axes
  for (int i = 0; i < 3; i++)
    axes[i] = glm::dvec3(place[i][0], place[i][1], place[i][2]);
  if (glm::determinant(axes) == 0)
    return {};
  const double shortest = 1 / longestImage(glm::inverse(axes)); // image of a unit vector
  if (!(shortest > 0) || !std::isfinite(shortest))
    return {};

  SbDPMatrix viewing, projection;
  volume.getDPViewVolume().getMatrices(viewing, projection);
  TeLodView view;
  view.perspective = volume.getProjectionType() == SbViewVolume::PERSPECTIVE;
  const double density =
      std::max(pixels[0] * std::abs(projection[0][0]), pixels[1] * std::abs(projection[1][1])) / 2;
  view.focal = density * glm::length(axes[2]) / (view.perspective ? shortest : 1.0);
  const SbVec3d& point = volume.getDPViewVolume().getProjectionPoint();
  SbVec3d eye;
  place.inverse().multVecMatrix(point, eye);
  view.eye = teToGlm(eye);

  SbDPMatrix clip = place;
  clip.multRight(viewing);
  clip.multRight(projection);
  const double margin = kPlaneMargin * glm::length(view.eye);
  for (int i = 0; i < 6; i++) {
    const int axis = i / 2;
    const double sign = i % 2 == 0 ? 1 : -1;
    glm::dvec4 plane;
    for (int row = 0; row < 4; row++)
      plane[row] = clip[row][3] + sign * clip[row][axis];
    plane /= glm::length(glm::dvec3(plane));
    plane.w += margin;
    view.planes[std::size_t(i)] = plane;
  }
  view.planeCount = 6;
  if (!isFinite(view))
    return {};
  return view;
}

bool TeCameraView::hasCamera(SoState* state) {
  const int index = SoViewVolumeElement::getClassStackIndex();
  if (!state->isElementEnabled(index) ||
      !state->isElementEnabled(SoViewportRegionElement::getClassStackIndex()) ||
      !state->isElementEnabled(SoModelMatrixElement::getClassStackIndex()))
    return false;
  const auto* element = static_cast<const SoViewVolumeElement*>(state->getConstElement(index));
  return element->getNodeId() != 0;
}

std::optional<TeLodView> TeCameraView::fromState(SoState* state) {
  return create(SoViewVolumeElement::get(state), SoViewportRegionElement::get(state).getViewportSizePixels(),
                SoModelMatrixElement::get(state));
}

std::optional<TeLodView> TeCameraView::fromCamera(const SoCamera& camera, SoState* state) {
  const SbViewportRegion& region = SoViewportRegionElement::get(state);
  const float aspect = region.getViewportAspectRatio();
  SbViewportRegion viewport = region;
  SbViewVolume volume;
  if (camera.viewportMapping.getValue() == SoCamera::ADJUST_CAMERA) {
    // As when it is traversed; Coin's own function for viewports takes them for squares here.
    volume = camera.getViewVolume(aspect);
    if (aspect < 1)
      volume.scale(1 / aspect);
  } else {
    volume = camera.getViewVolume(region, viewport);
  }
  return create(volume, viewport.getViewportSizePixels(), SoModelMatrixElement::get(state));
}
