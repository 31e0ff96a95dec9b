#pragma once

#include "generators/TeHeightMap.h"

#include <glm/vec3.hpp>

#include <memory>
#include <optional>

/// Bullet's height field (btHeightfieldTerrainShape in double precision, with its accelerator) over the same
/// samples: a peer to measure with. Sample (column, row) lies at ((column, row) - (side - 1) / 2)·spacing.
class TeBulletField {
public:
  /// `heights` must outlive it and have no missing samples.
  TeBulletField(const TeHeightMap& heights, double spacing);
  ~TeBulletField();

  /// performRaycast() along a segment: the part of it before the first hit.
  std::optional<double> cast(glm::dvec3 from, glm::dvec3 to) const;
  /// By a vertical segment through all heights.
  std::optional<double> heightAt(double x, double y) const;
  std::size_t bytes() const;

private:
  struct Shape;
  std::unique_ptr<Shape> m_shape;
};
