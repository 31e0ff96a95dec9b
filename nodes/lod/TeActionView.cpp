#include "nodes/lod/TeActionView.h"

#include "generators/base/TeHash.h"
#include "nodes/TeCoinVectors.h"
#include "nodes/lod/TeCameraView.h"

#include <Inventor/SbLine.h>
#include <Inventor/SbMatrix.h>
#include <Inventor/SoPath.h>
#include <Inventor/actions/SoAction.h>
#include <Inventor/elements/SoComplexityElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/misc/SoState.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kDefaultPixels = 1024;
constexpr double kRayMargin = 1e-6; ///< of what is added in single precision

/// Coin multiplies rows by matrices, glm matrices by columns: the same numbers in memory.
glm::dmat4 toGlm(const SbMatrix& matrix) {
  glm::dmat4 result;
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++)
      result[i][j] = double(matrix[i][j]);
  }
  return result;
}

} // namespace

std::optional<TeLodView> TeActionView::view(SoState* state, const SoCamera* lodCamera,
                                            const TeLodView& otherwise) {
  if (!TeCameraView::hasCamera(state))
    return otherwise;
  return lodCamera ? TeCameraView::fromCamera(*lodCamera, state) : TeCameraView::fromState(state);
}

TeLodView TeActionView::fromAbove(const glm::dvec3& corner, double side, double top) {
  TeLodView view;
  view.eye = {corner.x + side / 2, corner.y + side / 2, top + side};
  view.focal = kDefaultPixels;
  return view;
}

// Coin means any path to be looked at as a full one, which the sanitizer does not know.
__attribute__((no_sanitize("vptr"))) std::uint64_t TeActionView::placeOf(SoAction* action) {
  const auto* path = static_cast<const SoFullPath*>(action->getCurPath());
  std::uint64_t hash = 0;
  for (int i = 0; path && i < path->getLength(); i++) {
    const std::int32_t index = path->getIndex(i);
    hash = teHashBytes(&index, sizeof index, hash);
  }
  return hash;
}

double TeActionView::accuracyFactor(SoState* state) {
  double complexity = 0.5;
  if (state->isElementEnabled(SoComplexityElement::getClassStackIndex()))
    complexity = std::clamp(double(SoComplexityElement::get(state)), 0.0, 1.0);
  return std::pow(16.0, complexity - 0.5);
}

glm::dmat4 TeActionView::eyeFromModel(SoState* state) {
  return toGlm(SoViewingMatrixElement::get(state)) * toGlm(SoModelMatrixElement::get(state));
}

glm::dmat4 TeActionView::projection(SoState* state) { return toGlm(SoProjectionMatrixElement::get(state)); }

void TeActionView::seeOnly(const SbLine& line, double size, TeLodView& view) {
  const glm::dvec3 from = teToGlm(line.getPosition());
  const glm::dvec3 along = glm::normalize(teToGlm(line.getDirection()));
  const glm::dvec3 other = std::abs(along.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(along, other));
  const glm::dvec3 up = glm::cross(along, across);
  const double margin = kRayMargin * (glm::length(from) + size);
  view.planeCount = 0;
  for (const glm::dvec3& normal : {across, -across, up, -up, along})
    view.planes[std::size_t(view.planeCount++)] = glm::dvec4(normal, margin - glm::dot(normal, from));
}
