#include "nodes/seamless/TeSeamlessRenderer.h"

#include "nodes/seamless/TeSeamlessGlState.h"
#include "nodes/seamless/TeSeamlessUniforms.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace {

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

const void* indexOffset(const TeSeamlessDraw& draw) {
  return offset(std::size_t(draw.part.firstIndex) * sizeof(std::uint16_t));
}

TeError lacks(const TeSeamlessLook& look, const std::string& what) {
  return {"seamless patches: technique " + look.technique.name() + " needs " + what};
}

} // namespace

TeSeamlessRenderer::TeSeamlessRenderer(std::uint32_t context, const TeSeamlessLayout& layout,
                                       std::shared_ptr<const TeSeamlessParts> parts)
    : m_context(context), m_layout(layout), m_parts(std::move(parts)), m_isUsable(m_gl.load(context)),
      m_objects(m_gl), m_programs(m_gl, m_objects), m_textures(m_gl, m_objects) {}

void TeSeamlessRenderer::freeAll() {
  m_objects.removeAll();
  m_programs.clear();
  m_textures.clear();
  m_vertices = m_indices = m_instances = 0;
}

TeResult<TeSeamlessCounts> TeSeamlessRenderer::draw(const TeSeamlessLists& lists, const TeSeamlessLook& look,
                                                    const TeSeamlessFrame& frame) {
  if (TeStatus status = check(look, frame); !status)
    return status.error();
  if (!frame.isValid() || lists.draws().empty())
    return TeSeamlessCounts{};
  const TeSeamlessGlState state(m_gl);
  const std::int64_t before = m_textures.bytesUploaded() + m_staticBytes;
  makeObjects();
  const TeResult<Setup> setup = setUp(state, look, frame, false);
  if (!setup)
    return setup.error();
  if (look.wireframe)
    m_gl.polygonMode(GL_FRONT_AND_BACK, GL_LINE);
  TeSeamlessCounts counts = drawLists(lists, look, *setup);
  counts.bytesUploaded += m_textures.bytesUploaded() + m_staticBytes - before;
  return counts;
}

TeResult<std::vector<TeSeamlessRenderer::DrawnVertex>>
TeSeamlessRenderer::capture(const TeSeamlessLists& lists, const TeSeamlessLook& look,
                            const TeSeamlessFrame& frame) {
  if (TeStatus status = check(look, frame); !status)
    return status.error();
  std::vector<DrawnVertex> vertices;
  if (!frame.isValid() || lists.draws().empty())
    return vertices;
  for (const TeSeamlessDraw& draw : lists.draws())
    vertices.resize(vertices.size() + std::size_t(draw.part.count) * std::size_t(draw.instanceCount));
  const TeSeamlessGlState state(m_gl);
  makeObjects();
  const TeResult<Setup> setup = setUp(state, look, frame, true);
  if (!setup)
    return setup.error();

  GLint neighbour = 0;
  m_gl.getIntegerv(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, &neighbour);
  const GLsizeiptr bytes = GLsizeiptr(vertices.size() * sizeof(DrawnVertex));
  GLuint buffer = 0;
  m_gl.genBuffers(1, &buffer);
  m_gl.bindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  m_gl.bufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  const bool discards = m_gl.isEnabled(GL_RASTERIZER_DISCARD);
  m_gl.enable(GL_RASTERIZER_DISCARD);
  m_gl.beginTransformFeedback(GL_TRIANGLES);
  drawLists(lists, look, *setup);
  m_gl.endTransformFeedback();
  if (!discards)
    m_gl.disable(GL_RASTERIZER_DISCARD);
  m_gl.getBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, vertices.data());
  m_gl.bindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  m_gl.bindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, GLuint(neighbour));
  m_gl.deleteBuffers(1, &buffer);
  return vertices;
}

TeStatus TeSeamlessRenderer::check(const TeSeamlessLook& look, const TeSeamlessFrame& frame) const {
  if (!m_isUsable)
    return TeError{"seamless patches: this OpenGL context cannot draw them"};
  const int samples = m_layout.resolution() + 1;
  if (look.technique.heights == TeSeamlessTechnique::Heightmap) {
    if (!look.heights || look.heights->empty())
      return lacks(look, "a height map");
    if (look.heights->width() != samples || look.heights->height() != samples)
      return lacks(look, "a height map of " + std::to_string(samples) + "x" + std::to_string(samples) +
                             " samples, not " + std::to_string(look.heights->width()) + "x" +
                             std::to_string(look.heights->height()));
  }
  if (look.technique.heights == TeSeamlessTechnique::Clipmaps) {
    if (!frame.heightClipmap || !frame.heightClipmap->texture)
      return lacks(look, "a clipmap of heights");
    if (frame.heightClipmap->resolutionLog != m_layout.resolutionLog())
      return lacks(look, "a clipmap of as many samples as the terrain's resolution says");
  }
  if (look.technique.colours == TeSeamlessTechnique::Texture && !look.texture && !frame.colourClipmap)
    return lacks(look, "a texture");
  if (look.technique.colours == TeSeamlessTechnique::Detailmaps) {
    if (!look.mask)
      return lacks(look, "a mask");
    for (int i = 0; i < 4; i++)
      if (!look.details[std::size_t(i)])
        return lacks(look, "four detail textures; number " + std::to_string(i + 1) + " is missing");
  }
  return {};
}

TeSeamlessVariant TeSeamlessRenderer::variantOf(const TeSeamlessLook& look,
                                                const TeSeamlessFrame& frame) const {
  TeSeamlessVariant variant;
  if (look.technique.heights == TeSeamlessTechnique::Heightmap)
    variant.heights = TeSeamlessVariant::Map;
  if (look.technique.heights == TeSeamlessTechnique::Clipmaps)
    variant.heights = frame.heightClipmap->format == TeClipFormat::Short ? TeSeamlessVariant::ClipInteger
                                                                         : TeSeamlessVariant::ClipReal;
  constexpr TeSeamlessVariant::Colours colours[] = {TeSeamlessVariant::Plain, TeSeamlessVariant::Texture,
                                                    TeSeamlessVariant::Detailmaps, TeSeamlessVariant::Slope};
  variant.colours = colours[look.technique.colours];
  if (variant.colours == TeSeamlessVariant::Texture && frame.colourClipmap)
    variant.colours = TeSeamlessVariant::ColourClipmap;
  variant.morphs = look.geomorph && variant.heights != TeSeamlessVariant::Flat;
  return variant;
}

TeResult<TeSeamlessRenderer::Setup> TeSeamlessRenderer::setUp(const TeSeamlessGlState& state,
                                                              const TeSeamlessLook& look,
                                                              const TeSeamlessFrame& frame, bool captures) {
  TeSeamlessVariant variant = variantOf(look, frame);
  if (!captures)
    state.describe(variant);
  variant.capturesVertices = captures;
  if (TeStatus status = m_textures.bind(look, frame); !status)
    return status.error();
  const TeResult<const TeSeamlessProgram*> program = m_programs.get(variant);
  if (!program)
    return program.error();
  m_gl.useProgram((*program)->name);
  const TeSeamlessUniforms uniforms(m_gl, **program);
  uniforms.setFrame(frame, m_layout);
  uniforms.setLook(look, m_textures.slopeUnit());
  return Setup{*program, state.material()};
}

void TeSeamlessRenderer::makeObjects() {
  if (m_vertices)
    return;
  const auto make = [&](const void* data, std::size_t bytes) {
    const GLuint buffer = m_objects.addBuffer();
    m_gl.bindBuffer(GL_ARRAY_BUFFER, buffer);
    m_gl.bufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), data, GL_STATIC_DRAW);
    m_staticBytes += std::int64_t(bytes);
    return buffer;
  };
  const std::vector<TePartVertex>& vertices = m_parts->vertices();
  const std::vector<std::uint16_t>& indices = m_parts->indices();
  m_vertices = make(vertices.data(), vertices.size() * sizeof(TePartVertex));
  m_indices = make(indices.data(), indices.size() * sizeof(std::uint16_t));
  m_instances = m_objects.addBuffer();
}

TeSeamlessCounts TeSeamlessRenderer::drawLists(const TeSeamlessLists& lists, const TeSeamlessLook& look,
                                               const Setup& setup) {
  TeSeamlessCounts counts;
  m_gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices);
  m_gl.bindBuffer(GL_ARRAY_BUFFER, m_vertices);
  m_gl.vertexAttribIPointer(TeSeamlessShader::kVertexAttribute, 3, GL_UNSIGNED_SHORT, sizeof(TePartVertex),
                            nullptr);
  m_gl.enableVertexAttribArray(TeSeamlessShader::kVertexAttribute);
  if (look.technique.instanced) {
    const std::size_t bytes = lists.instances().size() * sizeof(TeSeamlessInstance);
    m_gl.bindBuffer(GL_ARRAY_BUFFER, m_instances);
    // New storage each frame: the old one may still be read from.
    m_gl.bufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), lists.instances().data(), GL_STREAM_DRAW);
    counts.bytesUploaded += std::int64_t(bytes);
    m_gl.enableVertexAttribArray(TeSeamlessShader::kInstanceAttribute);
    m_gl.vertexAttribDivisor(TeSeamlessShader::kInstanceAttribute, 1);
    bindInstances(0);
  }
  for (const TeSeamlessDraw& draw : lists.draws()) {
    setDraw(draw, look, setup);
    if (look.technique.instanced)
      drawInstanced(draw);
    else
      drawEach(draw, lists.instances());
    counts.drawCalls += look.technique.instanced ? 1 : draw.instanceCount;
    counts.instances += draw.instanceCount;
    counts.triangles += std::int64_t(draw.part.count / 3) * draw.instanceCount;
  }
  return counts;
}

void TeSeamlessRenderer::setDraw(const TeSeamlessDraw& draw, const TeSeamlessLook& look,
                                 const Setup& setup) const {
  const auto stepLog = [&](int side) { return m_layout.levels() - 1 - draw.indices[std::size_t(side)]; };
  m_gl.uniform4i(setup.program->sideStepLog, stepLog(TeNorth), stepLog(TeEast), stepLog(TeSouth),
                 stepLog(TeWest));
  glm::vec4 material = setup.material;
  if (look.technique.colours == TeSeamlessTechnique::Color)
    material *= glm::vec4(draw.kind == TeSeamlessDraw::Strip ? look.stripColour : look.tileColour, 1);
  m_gl.uniform4fv(setup.program->material, 1, &material[0]);
}

void TeSeamlessRenderer::bindInstances(std::int32_t first) const {
  const std::size_t start = std::size_t(first) * sizeof(TeSeamlessInstance);
  m_gl.vertexAttribIPointer(TeSeamlessShader::kInstanceAttribute, 4, GL_INT, sizeof(TeSeamlessInstance),
                            offset(start));
}

void TeSeamlessRenderer::drawInstanced(const TeSeamlessDraw& draw) const {
  if (m_gl.drawElementsInstancedBaseVertexBaseInstance) {
    m_gl.drawElementsInstancedBaseVertexBaseInstance(GL_TRIANGLES, draw.part.count, GL_UNSIGNED_SHORT,
                                                     indexOffset(draw), draw.instanceCount,
                                                     draw.part.firstVertex, GLuint(draw.firstInstance));
    return;
  }
  bindInstances(draw.firstInstance);
  m_gl.drawElementsInstancedBaseVertex(GL_TRIANGLES, draw.part.count, GL_UNSIGNED_SHORT, indexOffset(draw),
                                       draw.instanceCount, draw.part.firstVertex);
}

void TeSeamlessRenderer::drawEach(const TeSeamlessDraw& draw,
                                  const std::vector<TeSeamlessInstance>& instances) const {
  for (std::int32_t i = draw.firstInstance; i < draw.firstInstance + draw.instanceCount; i++) {
    const TeSeamlessInstance& instance = instances[std::size_t(i)];
    m_gl.vertexAttribI4i(TeSeamlessShader::kInstanceAttribute, instance.column, instance.row,
                         instance.cellsLog, GLint(instance.weights));
    m_gl.drawElementsBaseVertex(GL_TRIANGLES, draw.part.count, GL_UNSIGNED_SHORT, indexOffset(draw),
                                draw.part.firstVertex);
  }
}
