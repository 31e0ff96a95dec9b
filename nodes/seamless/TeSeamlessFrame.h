#pragma once

#include "nodes/seamless/TeSeamlessClipTexture.h"
#include "nodes/seamless/TeSeamlessSelector.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

/// From where a terrain is drawn. Vertices are computed relative to the eye, so that nothing depends on how
/// far the terrain is from any origin:
///
///   relative.xy = float(sample - eyeSample) · spacing - eyeFraction
///   relative.z  = height · heightScale + base
///
/// in float, each operation rounded, both in the shader and in relative(); equal samples have equal bits,
/// whatever patch they come from.
class TeSeamlessFrame {
public:
  /// `view`: from the terrain's coordinates to those of the eye, that is the scene's model matrix, then its
  /// viewing matrix, in glm's order (column vectors); `projection` from there to clip coordinates. Not
  /// isValid() if `view` has no inverse or a number is not finite: nothing is drawn then.
  TeSeamlessFrame(const TeSeamlessPlacement& placement, const glm::dmat4& view, const glm::dmat4& projection);

  bool isValid() const { return m_isValid; }
  const TeSeamlessPlacement& placement() const { return m_placement; }
  glm::dvec3 eye() const { return m_eye; } ///< in the terrain's coordinates
  glm::ivec2 eyeSample() const { return m_eyeSample; }
  glm::vec2 eyeFraction() const { return m_eyeFraction; }
  float spacing() const { return float(m_placement.spacing); }
  float heightScale() const { return float(m_placement.heightScale); }
  float base() const { return m_base; } ///< z of height 0 relative to the eye
  const glm::mat4& clipFromRelative() const { return m_clip; }
  const glm::mat4& viewFromRelative() const { return m_view; }

  /// The vertex shader's position of a sample, bit for bit. `height` in the unit of the samples.
  glm::vec3 relative(std::int32_t column, std::int32_t row, float height) const;

  /// Of the context that is drawn in; needed by the technique Clipmaps.
  const TeSeamlessClipTexture* heightClipmap = nullptr;
  /// In place of TeSeamlessLook::texture.
  const TeSeamlessClipTexture* colourClipmap = nullptr;

private:
  TeSeamlessPlacement m_placement;
  bool m_isValid = false;
  glm::dvec3 m_eye{0};
  glm::ivec2 m_eyeSample{0};
  glm::vec2 m_eyeFraction{0};
  float m_base = 0;
  glm::mat4 m_clip{1};
  glm::mat4 m_view{1};
};
