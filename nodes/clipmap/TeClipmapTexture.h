#pragma once

#include "nodes/clipmap/TeClipFormat.h"
#include "nodes/clipmap/TeClipWindows.h"
#include "nodes/clipmap/TeClipmapGl.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The images of TeClipWindows in one context: a GL_TEXTURE_2D_ARRAY, layer = level - baseLevel(), to be read
/// with texelFetch (no filtering, no mipmaps). Texel (c, r) of a layer is texel (c, r) of the level's image,
/// converted on the CPU (TeClipFormat), so that it has the same bits everywhere.
///
/// All calls with the context current. The texture has to be freed with free() before this goes; with a lost
/// context it is gone by itself, and the owner says so with forget().
class TeClipmapTexture {
public:
  TeClipmapTexture(std::uint32_t context, TeClipFormat format) : m_context(context), m_format(format) {}
  ~TeClipmapTexture();
  TeClipmapTexture(const TeClipmapTexture&) = delete;
  TeClipmapTexture& operator=(const TeClipmapTexture&) = delete;

  /// Uploads what has changed in the windows, always the same ones, and clears their uploads; the first time
  /// makes the texture with all that they have. Leaves texture and buffer bindings and the unpacking
  /// parameters as they were. Error: OpenGL too old or too small, samples that do not fit the format, out of
  /// memory on the GPU; then there is no texture, and each further call tries again.
  TeStatus update(TeClipWindows& windows);

  GLuint name() const { return m_texture; } ///< 0 before the first update
  TeClipFormat format() const { return m_format; }
  std::size_t bytes() const { return m_bytes; }                  ///< on the GPU
  std::int64_t bytesUploaded() const { return m_bytesUploaded; } ///< in texels' bytes, since it was made

  void free();
  void forget();

private:
  TeStatus make(const TeClipWindows& windows);
  void upload(const TeClipWindows& windows, const TeClipUpload& upload);

  std::uint32_t m_context;
  TeClipFormat m_format;
  TeClipmapGl m_gl;
  bool m_isLoaded = false;
  GLuint m_texture = 0;
  std::size_t m_bytes = 0;
  std::int64_t m_bytesUploaded = 0;
  std::vector<std::uint16_t> m_halves; ///< of one upload
  std::vector<float> m_floats;
};
