#include "nodes/clipmap/TeClipmapTexture.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace {

constexpr int kMostErrors = 16; ///< that others may have left; a lost context never runs out of them

struct PixelFormat {
  GLenum internal;
  GLenum format;
  GLenum type;
};

PixelFormat pixelFormat(TeClipFormat format, int bytesPerSample) {
  switch (format) {
  case TeClipFormat::Short:
    return {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT};
  case TeClipFormat::Half:
    return {GL_R16F, GL_RED, GL_HALF_FLOAT};
  case TeClipFormat::Float:
    return {GL_R32F, GL_RED, GL_FLOAT};
  case TeClipFormat::Colour:
    break;
  }
  return {GL_RGBA8, GLenum(bytesPerSample == 3 ? GL_RGB : GL_RGBA), GL_UNSIGNED_BYTE};
}

/// Sets how texels are unpacked, and the binding of the texture; puts all back in the end.
class UnpackState {
public:
  UnpackState(const TeClipmapGl& gl, GLint rowLength, GLuint texture) : m_gl(gl) {
    for (int i = 0; i < kCount; i++) {
      m_gl.getIntegerv(kNames[i], &m_before[i]);
      m_gl.pixelStorei(kNames[i], kNames[i] == GL_UNPACK_ALIGNMENT ? 1 : 0);
    }
    m_gl.pixelStorei(GL_UNPACK_ROW_LENGTH, rowLength);
    m_gl.getIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &m_buffer);
    m_gl.bindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    m_gl.getIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &m_texture);
    m_gl.bindTexture(GL_TEXTURE_2D_ARRAY, texture);
  }
  ~UnpackState() {
    m_gl.bindTexture(GL_TEXTURE_2D_ARRAY, GLuint(m_texture));
    m_gl.bindBuffer(GL_PIXEL_UNPACK_BUFFER, GLuint(m_buffer));
    for (int i = 0; i < kCount; i++)
      m_gl.pixelStorei(kNames[i], m_before[i]);
  }
  UnpackState(const UnpackState&) = delete;
  UnpackState& operator=(const UnpackState&) = delete;

private:
  static constexpr int kCount = 8;
  static constexpr GLenum kNames[kCount] = {
      GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST,   GL_UNPACK_ROW_LENGTH,  GL_UNPACK_SKIP_ROWS,
      GL_UNPACK_ALIGNMENT,  GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT};

  const TeClipmapGl& m_gl;
  GLint m_before[kCount] = {};
  GLint m_buffer = 0;
  GLint m_texture = 0;
};

} // namespace

TeClipmapTexture::~TeClipmapTexture() { assert(m_texture == 0); }

TeStatus TeClipmapTexture::update(TeClipWindows& windows) {
  if (!m_isLoaded) {
    if (TeStatus ok = m_gl.load(m_context); !ok)
      return ok;
    m_isLoaded = true;
  }
  const bool isNew = m_texture == 0;
  if (isNew) {
    if (TeStatus ok = make(windows); !ok)
      return ok;
  }
  const std::vector<TeClipUpload> uploads = isNew ? windows.allUploads() : windows.uploads();
  windows.clearUploads();
  if (uploads.empty())
    return {};
  const bool isConverted = m_format == TeClipFormat::Half || m_format == TeClipFormat::Float;
  const UnpackState state(m_gl, isConverted ? 0 : windows.side(), m_texture);
  for (const TeClipUpload& changed : uploads)
    upload(windows, changed);
  return {};
}

TeStatus TeClipmapTexture::make(const TeClipWindows& windows) {
  if ((m_format == TeClipFormat::Colour) == (windows.bytesPerSample() == 2))
    return TeError{"clipmaps: samples of " + std::to_string(windows.bytesPerSample()) +
                   " bytes do not fit the texture's format"};
  GLint mostTexels = 0;
  GLint mostLayers = 0;
  m_gl.getIntegerv(GL_MAX_TEXTURE_SIZE, &mostTexels);
  m_gl.getIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
  if (windows.side() > mostTexels || windows.levels() > mostLayers)
    return TeError{"clipmaps: textures of this OpenGL have at most " + std::to_string(mostTexels) +
                   " texels a side and " + std::to_string(mostLayers) + " layers; " +
                   std::to_string(windows.side()) + " and " + std::to_string(windows.levels()) +
                   " are needed"};
  const PixelFormat pixels = pixelFormat(m_format, windows.bytesPerSample());
  for (int i = 0; i < kMostErrors && m_gl.getError() != GL_NO_ERROR; i++) {
  }
  m_gl.genTextures(1, &m_texture);
  bool isMade = false;
  {
    const UnpackState state(m_gl, 0, m_texture);
    m_gl.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    m_gl.texParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    m_gl.texImage3D(GL_TEXTURE_2D_ARRAY, 0, GLint(pixels.internal), windows.side(), windows.side(),
                    windows.levels(), 0, pixels.format, pixels.type, nullptr);
    isMade = m_gl.getError() == GL_NO_ERROR;
  }
  if (!isMade) {
    free();
    return TeError{"clipmaps: OpenGL has no memory for " + std::to_string(windows.levels()) + " layers of " +
                   std::to_string(windows.side()) + "x" + std::to_string(windows.side()) + " texels"};
  }
  m_bytes = std::size_t(windows.side()) * std::size_t(windows.side()) * std::size_t(windows.levels()) *
            std::size_t(teTexelBytes(m_format));
  return {};
}

void TeClipmapTexture::upload(const TeClipWindows& windows, const TeClipUpload& upload) {
  const TeSampleRect& texels = upload.texels;
  const unsigned char* samples = windows.samples(upload);
  const void* data = samples;
  const auto convert = [&](auto& converted, auto texel) {
    converted.resize(std::size_t(texels.count()));
    auto to = converted.begin();
    for (std::int32_t y = 0; y < texels.rows; y++) {
      const unsigned char* row = samples + std::size_t(y) * windows.rowBytes();
      for (std::int32_t x = 0; x < texels.columns; x++)
        *to++ = texel(std::uint16_t(row[2 * x] | row[2 * x + 1] << 8));
    }
    data = converted.data();
  };
  if (m_format == TeClipFormat::Half)
    convert(m_halves, teHalfOfSample);
  else if (m_format == TeClipFormat::Float)
    convert(m_floats, [](std::uint16_t sample) { return float(sample); });
  const PixelFormat pixels = pixelFormat(m_format, windows.bytesPerSample());
  m_gl.texSubImage3D(GL_TEXTURE_2D_ARRAY, 0, texels.x, texels.y, upload.level - windows.baseLevel(),
                     texels.columns, texels.rows, 1, pixels.format, pixels.type, data);
  m_bytesUploaded += texels.count() * teTexelBytes(m_format);
}

void TeClipmapTexture::free() {
  if (m_texture)
    m_gl.deleteTextures(1, &m_texture);
  forget();
}

void TeClipmapTexture::forget() {
  m_texture = 0;
  m_bytes = 0;
}
