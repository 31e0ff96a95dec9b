#include "nodes/seamless/TeSeamlessTextures.h"

#include "nodes/seamless/TeSeamlessShader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace {

constexpr float kMaxShort = 32767;
constexpr int kRowsAtOnce = 64;

std::string sizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

/// Pixels are read from our memory, tightly packed, whatever a neighbour has set.
class UnpackState {
public:
  explicit UnpackState(const TeSeamlessGl& gl) : m_gl(gl) {
    gl.getIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &m_buffer);
    gl.pushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    gl.bindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (const GLenum name : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                              GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST})
      gl.pixelStorei(name, 0);
    gl.pixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }
  ~UnpackState() {
    m_gl.popClientAttrib();
    m_gl.bindBuffer(GL_PIXEL_UNPACK_BUFFER, GLuint(m_buffer));
  }
  UnpackState(const UnpackState&) = delete;
  UnpackState& operator=(const UnpackState&) = delete;

private:
  const TeSeamlessGl& m_gl;
  GLint m_buffer = 0;
};

/// Slopes of a sample from its neighbours, one-sided on the rim.
struct Slope {
  float east;
  float north;
};
Slope slopeAt(const TeHeightMap& heights, int x, int y) {
  const int west = std::max(x - 1, 0), east = std::min(x + 1, heights.width() - 1);
  const int south = std::max(y - 1, 0), north = std::min(y + 1, heights.height() - 1);
  return {(heights.at(east, y) - heights.at(west, y)) / float(std::max(east - west, 1)),
          (heights.at(x, north) - heights.at(x, south)) / float(std::max(north - south, 1))};
}

std::uint32_t packed(const Slope& slope, float unit) {
  const auto part = [&](float value) {
    return std::uint32_t(std::int32_t(std::clamp(std::round(value / unit), -kMaxShort, kMaxShort))) & 0xFFFF;
  };
  return part(slope.east) | part(slope.north) << 16;
}

} // namespace

TeStatus TeSeamlessTextures::checkSize(const char* what, int width, int height, const char* advice) const {
  GLint largest = 0;
  m_gl.getIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (width > 0 && height > 0 && width <= largest && height <= largest)
    return {};
  return TeError{std::string("seamless patches: ") + what + " of " + sizeText(width, height) +
                 " does not fit into a texture, which this OpenGL allows to be " +
                 sizeText(largest, largest) + advice};
}

TeStatus TeSeamlessTextures::outOfMemory(const char* what) const {
  if (m_gl.getError() == GL_OUT_OF_MEMORY)
    return TeError{std::string("seamless patches: OpenGL has not enough memory for ") + what};
  return {};
}

TeResult<GLuint> TeSeamlessTextures::heights(const std::shared_ptr<const TeHeightMap>& heights) {
  if (heights == m_heightSource)
    return m_heights;
  if (TeStatus status =
          checkSize("a height map", heights->width(), heights->height(), "; draw it by clipmaps");
      !status)
    return status.error();
  if (heights->hasMissing())
    return TeError{"seamless patches: a height map with missing samples cannot be drawn"};
  m_objects.removeTexture(m_heights);
  m_heightSource = nullptr;
  m_heights = m_objects.addTexture();
  if (TeStatus status = uploadHeights(*heights); !status) {
    m_objects.removeTexture(m_heights);
    m_heights = 0;
    return status.error();
  }
  m_heightSource = heights;
  return m_heights;
}

TeStatus TeSeamlessTextures::uploadHeights(const TeHeightMap& heights) {
  float steepest = 0;
  for (int y = 0; y < heights.height(); y++)
    for (int x = 0; x < heights.width(); x++) {
      const Slope slope = slopeAt(heights, x, y);
      steepest = std::max({steepest, std::abs(slope.east), std::abs(slope.north)});
    }
  m_slopeUnit = steepest > 0 && std::isfinite(steepest) ? steepest / kMaxShort : 1;

  const UnpackState unpack(m_gl);
  m_gl.bindTexture(GL_TEXTURE_2D, m_heights);
  m_gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  m_gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  m_gl.texImage2D(GL_TEXTURE_2D, 0, GL_RG32UI, heights.width(), heights.height(), 0, GL_RG_INTEGER,
                  GL_UNSIGNED_INT, nullptr);
  std::vector<std::uint32_t> texels(std::size_t(2) * heights.width() * kRowsAtOnce);
  for (int start = 0; start < heights.height(); start += kRowsAtOnce) {
    const int rows = std::min(kRowsAtOnce, heights.height() - start);
    std::uint32_t* texel = texels.data();
    for (int y = start; y < start + rows; y++)
      for (int x = 0; x < heights.width(); x++, texel += 2) {
        const float height = heights.at(x, y);
        std::memcpy(texel, &height, sizeof height);
        texel[1] = packed(slopeAt(heights, x, y), m_slopeUnit);
      }
    m_gl.texSubImage2D(GL_TEXTURE_2D, 0, 0, start, heights.width(), rows, GL_RG_INTEGER, GL_UNSIGNED_INT,
                       texels.data());
    m_bytesUploaded += std::int64_t(8) * heights.width() * rows;
  }
  return outOfMemory("a height map");
}

TeResult<GLuint> TeSeamlessTextures::picture(Use use, const std::shared_ptr<const TePicture>& picture) {
  Picture& held = m_pictures[std::size_t(use)];
  if (picture == held.source)
    return held.texture;
  if (TeStatus status = checkSize("a picture", picture->width, picture->height, ""); !status)
    return status.error();
  if (picture->rgba.size() != std::size_t(4) * picture->width * picture->height)
    return TeError{"seamless patches: a picture has not as many pixels as its sides say"};
  m_objects.removeTexture(held.texture);
  held = {};
  const GLuint texture = m_objects.addTexture();
  const UnpackState unpack(m_gl);
  m_gl.bindTexture(GL_TEXTURE_2D, texture);
  const GLint wrap = use == Colours ? GL_CLAMP_TO_EDGE : GL_REPEAT;
  m_gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  m_gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  m_gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  m_gl.texImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture->width, picture->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  picture->rgba.data());
  m_gl.generateMipmap(GL_TEXTURE_2D);
  m_bytesUploaded += std::int64_t(picture->rgba.size());
  if (TeStatus status = outOfMemory("a picture"); !status) {
    m_objects.removeTexture(texture);
    return status.error();
  }
  held = {picture, texture};
  return texture;
}

TeStatus TeSeamlessTextures::bind(const TeSeamlessLook& look, const TeSeamlessFrame& frame) {
  makeSamplers();
  m_gl.activeTexture(GL_TEXTURE0);
  m_gl.bindSampler(TeSeamlessShader::kHeightsUnit, 0);
  if (look.technique.heights == TeSeamlessTechnique::Heightmap) {
    const TeResult<GLuint> heights = this->heights(look.heights);
    if (!heights)
      return heights.error();
    m_gl.bindTexture(GL_TEXTURE_2D, *heights);
  } else if (look.technique.heights == TeSeamlessTechnique::Clipmaps) {
    m_gl.bindTexture(GL_TEXTURE_2D_ARRAY, frame.heightClipmap->texture);
    m_gl.bindSampler(TeSeamlessShader::kHeightsUnit, m_texelSampler);
  }
  const TeStatus status = bindColours(look, frame);
  m_gl.activeTexture(GL_TEXTURE0);
  return status;
}

TeStatus TeSeamlessTextures::bindColours(const TeSeamlessLook& look, const TeSeamlessFrame& frame) {
  const int unit = TeSeamlessShader::kColoursUnit;
  if (look.technique.colours == TeSeamlessTechnique::Texture) {
    if (!frame.colourClipmap)
      return bindPicture(unit, Colours, look.texture);
    m_gl.activeTexture(GLenum(GL_TEXTURE0 + unit));
    m_gl.bindTexture(GL_TEXTURE_2D_ARRAY, frame.colourClipmap->texture);
    m_gl.bindSampler(GLuint(unit), m_colourSampler);
  }
  if (look.technique.colours != TeSeamlessTechnique::Detailmaps)
    return {};
  for (int i = 0; i < 4; i++) {
    const auto use = Use(FirstDetail + i);
    if (TeStatus status =
            bindPicture(TeSeamlessShader::kFirstDetailUnit + i, use, look.details[std::size_t(i)]);
        !status)
      return status;
  }
  return bindPicture(unit, Colours, look.mask);
}

TeStatus TeSeamlessTextures::bindPicture(int unit, Use use, const std::shared_ptr<const TePicture>& picture) {
  m_gl.activeTexture(GLenum(GL_TEXTURE0 + unit));
  m_gl.bindSampler(GLuint(unit), 0);
  const TeResult<GLuint> texture = this->picture(use, picture);
  if (!texture)
    return texture.error();
  m_gl.bindTexture(GL_TEXTURE_2D, *texture);
  return {};
}

void TeSeamlessTextures::makeSamplers() {
  if (m_texelSampler)
    return;
  const auto sampler = [&](GLint filter) {
    const GLuint name = m_objects.addSampler();
    m_gl.samplerParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
    m_gl.samplerParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
    m_gl.samplerParameteri(name, GL_TEXTURE_WRAP_S, GL_REPEAT);
    m_gl.samplerParameteri(name, GL_TEXTURE_WRAP_T, GL_REPEAT);
    return name;
  };
  m_texelSampler = sampler(GL_NEAREST);
  m_colourSampler = sampler(GL_LINEAR);
}

void TeSeamlessTextures::clear() {
  m_heightSource = nullptr;
  m_heights = 0;
  m_pictures = {};
  m_texelSampler = m_colourSampler = 0;
}
