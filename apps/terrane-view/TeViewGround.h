#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/nodes/SoSeparator.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <optional>

/// Tells how high the ground is, for flying over it.
class TeViewGround {
public:
  virtual ~TeViewGround() = default;
  /// None where there is no ground.
  virtual std::optional<double> heightAt(glm::dvec2 place) const = 0;
};

/// Bilinear in a square map over a square of the world.
class TeMapGround : public TeViewGround {
public:
  /// `corner`: of sample (0, 0); z is added to scaled heights.
  TeMapGround(std::shared_ptr<const TeHeightMap> map, const glm::dvec3& corner, double spacing,
              double heightScale)
      : m_map(std::move(map)), m_corner(corner), m_spacing(spacing), m_heightScale(heightScale) {}
  std::optional<double> heightAt(glm::dvec2 place) const override;

private:
  std::shared_ptr<const TeHeightMap> m_map;
  glm::dvec3 m_corner;
  double m_spacing;
  double m_heightScale;
};

/// The topmost of a scene's shapes, by picking.
class TePickGround : public TeViewGround {
public:
  /// `top`: above all of the scene; `depth`: from there to below all of it.
  TePickGround(SoSeparator* scene, double top, double depth) : m_scene(scene), m_top(top), m_depth(depth) {}
  std::optional<double> heightAt(glm::dvec2 place) const override;

private:
  TeNodePtr<SoSeparator> m_scene;
  double m_top;
  double m_depth;
};
