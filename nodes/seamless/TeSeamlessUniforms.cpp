#include "nodes/seamless/TeSeamlessUniforms.h"

#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>

namespace {

int layers(const TeSeamlessClipTexture& clipmap) {
  return std::min(int(clipmap.residency.windows.size()), TeSeamlessClipTexture::kMaxLevels);
}

} // namespace

void TeSeamlessUniforms::setFrame(const TeSeamlessFrame& frame, const TeSeamlessLayout& layout) const {
  m_gl.uniform2i(m_program.eyeSample, frame.eyeSample().x, frame.eyeSample().y);
  m_gl.uniform2f(m_program.eyeFraction, frame.eyeFraction().x, frame.eyeFraction().y);
  m_gl.uniform1f(m_program.spacing, frame.spacing());
  m_gl.uniform2f(m_program.heightToZ, frame.heightScale(), frame.base());
  m_gl.uniform1f(m_program.slopeScale, frame.heightScale() / frame.spacing());
  m_gl.uniform1i(m_program.patchLog, layout.maxResolutionLog());
  m_gl.uniform1f(m_program.terrainFromSample, 1 / float(layout.resolution()));
  m_gl.uniformMatrix4fv(m_program.clipFromRelative, 1, GL_FALSE, &frame.clipFromRelative()[0][0]);
  const glm::mat3 view(frame.viewFromRelative());
  const glm::mat3 normals(glm::transpose(glm::inverse(glm::dmat3(view))));
  m_gl.uniformMatrix3fv(m_program.viewFromRelative, 1, GL_FALSE, &view[0][0]);
  m_gl.uniformMatrix3fv(m_program.viewFromNormal, 1, GL_FALSE, &normals[0][0]);
  if (frame.heightClipmap)
    setHeightClipmap(*frame.heightClipmap);
  if (frame.colourClipmap)
    setColourClipmap(*frame.colourClipmap);
}

void TeSeamlessUniforms::setHeightClipmap(const TeSeamlessClipTexture& clipmap) const {
  std::array<glm::ivec4, 2 * TeSeamlessClipTexture::kMaxLevels> windows{};
  for (int i = 0; i < layers(clipmap); i++) {
    const TeClipWindow& window = clipmap.residency.windows[std::size_t(i)];
    windows[std::size_t(2 * i)] = {window.x, window.y, window.x % clipmap.clipSize,
                                   window.y % clipmap.clipSize};
    windows[std::size_t(2 * i + 1)].x = window.side;
  }
  m_gl.uniform4iv(m_program.clipWindows, 2 * layers(clipmap), &windows[0][0]);
  m_gl.uniform4i(m_program.clip, clipmap.clipSize, clipmap.residency.base, std::max(layers(clipmap) - 1, 0),
                 clipmap.resolutionLog);
  m_gl.uniform1f(m_program.heightUnit, teTexelScale(clipmap.format));
}

void TeSeamlessUniforms::setColourClipmap(const TeSeamlessClipTexture& clipmap) const {
  std::array<glm::ivec4, TeSeamlessClipTexture::kMaxLevels> windows{};
  for (int i = 0; i < layers(clipmap); i++) {
    const TeClipWindow& window = clipmap.residency.windows[std::size_t(i)];
    windows[std::size_t(i)] = {window.x, window.y, window.side, 0};
  }
  m_gl.uniform4iv(m_program.colourWindows, layers(clipmap), &windows[0][0]);
  m_gl.uniform4i(m_program.colourClip, clipmap.clipSize, clipmap.residency.base,
                 std::max(layers(clipmap) - 1, 0), clipmap.resolutionLog);
}

void TeSeamlessUniforms::setLook(const TeSeamlessLook& look, float slopeUnit) const {
  m_gl.uniform1f(m_program.slopeUnit, slopeUnit);
  m_gl.uniform1f(m_program.detailScale, look.detailScale);
  if (m_program.groundLayers < 0)
    return;
  std::array<glm::vec4, 10> layers{};
  for (std::size_t i = 0; i < look.slopes.layers.size(); i++) {
    const TeSeamlessSlopeColours::Layer& layer = look.slopes.layers[i];
    layers[2 * i] = {layer.colour, layer.line};
    layers[2 * i + 1].x = layer.slope;
  }
  m_gl.uniform4fv(m_program.groundLayers, GLsizei(layers.size()), &layers[0][0]);
  m_gl.uniform2f(m_program.groundBlend, look.slopes.blend, look.slopes.slopeBlend);
}
