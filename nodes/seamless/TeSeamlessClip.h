#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/clipmap/SoTeClipmap.h"
#include "nodes/clipmap/TeClipmapTexture.h"
#include "nodes/seamless/TeSeamlessClipTexture.h"
#include "nodes/seamless/TeSeamlessMesh.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <memory>

/// A clipmap as one viewer has it: windows around his eye, and in an OpenGL context their texture.
///
/// The texture has to be given back with release(). For the thread that makes all Coin calls.
class TeSeamlessClip {
public:
  /// `context`: in which it will be drawn. `highest`: level of the pyramid that is the terrain's finest; -1
  /// its own highest. Error: what the node or TeClipWindows::create() says.
  static TeResult<std::shared_ptr<TeSeamlessClip>> create(SoTeClipmap* node, std::uint32_t context,
                                                          int highest = -1);

  /// Moves the windows toward a point, (0, 0) the terrain's south-west and (1, 1) its north-east corner,
  /// within the node's budget or without one.
  void follow(glm::dvec2 centre, bool inBudget);
  /// Whether following the same point would change nothing.
  bool isSettled() const { return m_windows->isSettled(); }
  const TeClipWindows& windows() const { return *m_windows; }
  /// Of what is drawn, or will be first.
  TeClipFormat format() const { return m_texture->format(); }
  const TeClipResidency& residency() const { return m_windows->residency(); }

  /// Makes the texture that of the windows; the context is current. Errors of TeClipmapTexture::update().
  TeStatus upload();
  /// As it was with the last upload().
  const TeSeamlessClipTexture& texture() const { return m_shown; }
  /// To the GPU, so far.
  std::int64_t bytesUploaded() const { return m_texture->bytesUploaded(); }
  std::size_t textureBytes() const { return m_texture->bytes(); }

  /// Frees the texture when the context is next current.
  static void release(const std::shared_ptr<TeSeamlessClip>& clip);
  /// Frees it now: the context is current.
  void free() { m_texture->free(); }

private:
  TeSeamlessClip() = default;
  void makeTexture();

  TeNodePtr<SoTeClipmap> m_node;
  std::uint32_t m_context = 0;
  int m_level = 0; ///< of which centres are given in samples
  std::unique_ptr<TeClipWindows> m_windows;
  std::unique_ptr<TeClipmapTexture> m_texture;
  TeSeamlessClipTexture m_shown;
};

/// Heights as a clip draws them. The windows must outlive it.
class TeSeamlessClipHeights final : public TeSeamlessHeights {
public:
  /// `resolutionLog`: of the terrain.
  TeSeamlessClipHeights(const TeClipWindows& windows, TeClipFormat format, int resolutionLog)
      : m_windows(windows), m_format(format), m_resolutionLog(resolutionLog) {}
  float height(std::int32_t column, std::int32_t row, int heightLevel) const override {
    const int shift = m_resolutionLog - heightLevel;
    return teDrawnHeight(m_windows.height(heightLevel, column >> shift, row >> shift), m_format);
  }

private:
  const TeClipWindows& m_windows;
  TeClipFormat m_format;
  int m_resolutionLog;
};
