#pragma once

#include "nodes/seamless/TeSeamlessCounts.h"
#include "nodes/seamless/TeSeamlessFrame.h"
#include "nodes/seamless/TeSeamlessLists.h"
#include "nodes/seamless/TeSeamlessLook.h"
#include "nodes/seamless/TeSeamlessParts.h"

#include <cstdint>
#include <map>
#include <memory>

class TeSeamlessRenderer;

/// Draws terrains of one layout in any number of OpenGL contexts, each of which has a TeSeamlessRenderer.
/// For the thread that makes all Coin calls.
class TeSeamlessDrawing {
public:
  TeSeamlessDrawing(const TeSeamlessLayout& layout, std::shared_ptr<const TeSeamlessParts> parts);
  /// Its OpenGL objects go when their contexts are next drawn in, or go.
  ~TeSeamlessDrawing();
  TeSeamlessDrawing(const TeSeamlessDrawing&) = delete;
  TeSeamlessDrawing& operator=(const TeSeamlessDrawing&) = delete;

  /// Draws in the current context, which Coin knows by this number, with the lights, material, fog and clip
  /// planes that OpenGL has; leaves all state of OpenGL as it was. Error, with nothing drawn: what
  /// TeSeamlessRenderer::draw() names. A context that cannot draw at all is one line in TeLog, then an error
  /// each time.
  TeResult<TeSeamlessCounts> draw(std::uint32_t context, const TeSeamlessLists& lists,
                                  const TeSeamlessLook& look, const TeSeamlessFrame& frame);

  /// Null before the first draw() in that context.
  TeSeamlessRenderer* renderer(std::uint32_t context);

private:
  static void freeWhenCurrent(const std::shared_ptr<TeSeamlessRenderer>& renderer);
  static void onContextDestroyed(std::uint32_t context, void* drawing);

  TeSeamlessLayout m_layout;
  std::shared_ptr<const TeSeamlessParts> m_parts;
  std::map<std::uint32_t, std::shared_ptr<TeSeamlessRenderer>> m_renderers;
};
