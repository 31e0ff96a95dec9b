#include "nodes/lod/TePerspectiveView.h"

#include <glm/geometric.hpp>

#include <cmath>

glm::dvec3 TePerspectiveView::right() const {
  return glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
}

glm::dvec3 TePerspectiveView::up() const { return glm::cross(right(), forward); }

TeLodView TePerspectiveView::lodView() const {
  const double tangent = std::tan(0.5 * fieldOfView);
  const double across = tangent * double(width) / double(height);
  const glm::dvec3 x = right();
  const glm::dvec3 y = up();
  TeLodView view;
  view.eye = eye;
  view.focal = 0.5 * double(height) / tangent;
  const auto plane = [&](const glm::dvec3& normal, double offset) {
    const glm::dvec3 unit = glm::normalize(normal);
    view.planes[std::size_t(view.planeCount)] = glm::dvec4(unit, -glm::dot(unit, eye) - offset);
    view.planeCount++;
  };
  plane(forward, nearDistance);
  plane(-forward, -farDistance);
  plane(forward * across + x, 0);
  plane(forward * across - x, 0);
  plane(forward * tangent + y, 0);
  plane(forward * tangent - y, 0);
  return view;
}
