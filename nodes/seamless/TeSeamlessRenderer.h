#pragma once

#include "nodes/seamless/TeSeamlessCounts.h"
#include "nodes/seamless/TeSeamlessFrame.h"
#include "nodes/seamless/TeSeamlessLists.h"
#include "nodes/seamless/TeSeamlessLook.h"
#include "nodes/seamless/TeSeamlessParts.h"
#include "nodes/seamless/TeSeamlessPrograms.h"
#include "nodes/seamless/TeSeamlessTextures.h"

#include <cstdint>
#include <memory>
#include <vector>

class TeSeamlessGlState;

/// Draws the lists of Seamless Patches in one context. Tiles and strips lie there once, of unit size; a frame
/// uploads its instances (instanced) or nothing (classic, where an instance is constant attributes).
///
/// All calls with the context current, except context(), isUsable() and the counts.
class TeSeamlessRenderer {
public:
  /// A vertex as the vertex shader computed it.
  struct DrawnVertex {
    glm::vec3 relative{0}; ///< to the eye, metres
    std::int32_t column = 0;
    std::int32_t row = 0;
    float height = 0; ///< in the unit of the samples, morphed
  };

  /// For the current context. One line in TeLog if it cannot be drawn in.
  TeSeamlessRenderer(std::uint32_t context, const TeSeamlessLayout& layout,
                     std::shared_ptr<const TeSeamlessParts> parts);
  TeSeamlessRenderer(const TeSeamlessRenderer&) = delete;
  TeSeamlessRenderer& operator=(const TeSeamlessRenderer&) = delete;

  std::uint32_t context() const { return m_context; }
  bool isUsable() const { return m_isUsable; }
  /// Programs that were needed so far; a technique is compiled when it is first drawn.
  int programsCompiled() const { return m_programs.compiled(); }

  /// TeSeamlessDrawing::draw(). Error, with nothing drawn: the technique lacks its heights, textures or
  /// clipmap, or these have a wrong size or do not fit into this OpenGL; a shader does not compile. Frames
  /// that are not valid draw nothing.
  TeResult<TeSeamlessCounts> draw(const TeSeamlessLists& lists, const TeSeamlessLook& look,
                                  const TeSeamlessFrame& frame);
  /// Computes the vertices that draw() would have drawn, three a triangle, in the order of the lists and
  /// their instances, and draws nothing: for tests, and where no copy of the shader's arithmetic will do.
  TeResult<std::vector<DrawnVertex>> capture(const TeSeamlessLists& lists, const TeSeamlessLook& look,
                                             const TeSeamlessFrame& frame);

  /// Frees all objects; the next draw() makes them anew.
  void freeAll();

private:
  /// What a frame is drawn with.
  struct Setup {
    const TeSeamlessProgram* program = nullptr;
    glm::vec4 material{1};
  };

  TeStatus check(const TeSeamlessLook& look, const TeSeamlessFrame& frame) const;
  TeResult<Setup> setUp(const TeSeamlessGlState& state, const TeSeamlessLook& look,
                        const TeSeamlessFrame& frame, bool captures);
  TeSeamlessVariant variantOf(const TeSeamlessLook& look, const TeSeamlessFrame& frame) const;
  void makeObjects();
  TeSeamlessCounts drawLists(const TeSeamlessLists& lists, const TeSeamlessLook& look, const Setup& setup);
  void setDraw(const TeSeamlessDraw& draw, const TeSeamlessLook& look, const Setup& setup) const;
  void bindInstances(std::int32_t first) const;
  void drawInstanced(const TeSeamlessDraw& draw) const;
  void drawEach(const TeSeamlessDraw& draw, const std::vector<TeSeamlessInstance>& instances) const;

  std::uint32_t m_context;
  TeSeamlessLayout m_layout;
  std::shared_ptr<const TeSeamlessParts> m_parts;
  TeSeamlessGl m_gl;
  bool m_isUsable;
  TeSeamlessObjects m_objects;
  TeSeamlessPrograms m_programs;
  TeSeamlessTextures m_textures;
  GLuint m_vertices = 0;
  GLuint m_indices = 0;
  GLuint m_instances = 0;
  std::int64_t m_staticBytes = 0;
};
