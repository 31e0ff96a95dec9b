#include "nodes/TeSceneRenderer.h"

#include "nodes/TeClipPlanes.h"

#include <GL/glext.h>
#include <Inventor/nodes/SoNode.h>

#include <algorithm>
#include <cstdio>

namespace {

/// Binds a framebuffer and binds again the one before when it goes.
class BoundFramebuffer {
public:
  BoundFramebuffer(const TeGlTable& gl, GLuint framebuffer) : m_gl(gl) {
    m_gl.getIntegerv(GL_FRAMEBUFFER_BINDING, &m_before);
    m_gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  }
  ~BoundFramebuffer() { m_gl.bindFramebuffer(GL_FRAMEBUFFER, GLuint(m_before)); }
  BoundFramebuffer(const BoundFramebuffer&) = delete;
  BoundFramebuffer& operator=(const BoundFramebuffer&) = delete;

private:
  const TeGlTable& m_gl;
  GLint m_before = 0;
};

std::string hexadecimal(GLenum value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04x", value);
  return text;
}

} // namespace

TeResult<std::unique_ptr<TeSceneRenderer>> TeSceneRenderer::create(TeContext& context, int width, int height,
                                                                   int samples) {
  if (width < 1 || height < 1 || width > TePicture::kMaxSide || height > TePicture::kMaxSide)
    return TeError{"picture of " + std::to_string(width) + "x" + std::to_string(height) +
                   ": sides must be 1 to " + std::to_string(TePicture::kMaxSide)};
  if (samples < 1)
    return TeError{"picture with " + std::to_string(samples) + " samples a pixel: at least 1 is needed"};
  if (TeStatus status = context.makeCurrent(); !status)
    return status.error();
  GLint most = 1;
  context.gl().getIntegerv(GL_MAX_SAMPLES, &most);
  samples = std::min(samples, std::max(1, int(most)));

  std::unique_ptr<TeSceneRenderer> renderer(new TeSceneRenderer(context, width, height));
  if (TeStatus status = renderer->createTarget(renderer->m_target, samples); !status)
    return status.error();
  if (samples > 1) {
    if (TeStatus status = renderer->createTarget(renderer->m_resolved, 1); !status)
      return status.error();
  }
  return renderer;
}

TeSceneRenderer::TeSceneRenderer(TeContext& context, int width, int height)
    : m_context(context), m_width(width), m_height(height),
      m_action(SbViewportRegion(short(width), short(height))) {
  m_action.setCacheContext(context.id());
  m_action.setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
}

TeSceneRenderer::~TeSceneRenderer() {
  if (!m_context.makeCurrent())
    return;
  destroyTarget(m_target);
  destroyTarget(m_resolved);
}

TeStatus TeSceneRenderer::createTarget(Target& target, int samples) {
  const TeGlTable& gl = m_context.gl();
  const GLsizei stored = samples > 1 ? samples : 0;
  gl.genFramebuffers(1, &target.framebuffer);
  gl.genRenderbuffers(1, &target.colour);
  gl.genRenderbuffers(1, &target.depth);
  const BoundFramebuffer bound(gl, target.framebuffer);
  gl.bindRenderbuffer(GL_RENDERBUFFER, target.colour);
  gl.renderbufferStorageMultisample(GL_RENDERBUFFER, stored, GL_RGBA8, m_width, m_height);
  gl.framebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour);
  gl.bindRenderbuffer(GL_RENDERBUFFER, target.depth);
  gl.renderbufferStorageMultisample(GL_RENDERBUFFER, stored, GL_DEPTH24_STENCIL8, m_width, m_height);
  gl.framebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, target.depth);
  gl.bindRenderbuffer(GL_RENDERBUFFER, 0);
  const GLenum status = gl.checkFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    return TeError{"OpenGL refuses a framebuffer of " + std::to_string(m_width) + "x" +
                   std::to_string(m_height) + " (" + hexadecimal(status) + ")"};
  return {};
}

void TeSceneRenderer::destroyTarget(Target& target) {
  const TeGlTable& gl = m_context.gl();
  gl.deleteFramebuffers(1, &target.framebuffer);
  gl.deleteRenderbuffers(1, &target.colour);
  gl.deleteRenderbuffers(1, &target.depth);
}

TeStatus TeSceneRenderer::draw(SoNode* scene) {
  if (TeStatus status = m_context.makeCurrent(); !status)
    return status;
  if (m_fitsClipPlanes) {
    if (TeStatus status = teFitClipPlanes(scene, m_action.getViewportRegion()); !status)
      return status;
  }
  const TeGlTable& gl = m_context.gl();
  const BoundFramebuffer bound(gl, m_target.framebuffer);
  gl.viewport(0, 0, m_width, m_height);
  gl.clearColor(m_background[0], m_background[1], m_background[2], 1);
  gl.clearDepth(1);
  gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.enable(GL_DEPTH_TEST);
  m_action.apply(scene);
  gl.finish();
  if (const GLenum error = gl.getError(); error != GL_NO_ERROR)
    return TeError{"OpenGL error " + hexadecimal(error) + " while drawing"};
  return {};
}

TeResult<TePicture> TeSceneRenderer::render(SoNode* scene) {
  if (TeStatus status = draw(scene); !status)
    return status.error();
  TeResult<TePicture> picture = read();
  if (!picture)
    return picture;
  // Blending leaves its traces in the alpha that was drawn; what is seen is opaque.
  for (std::size_t alpha = 3; alpha < picture->rgba.size(); alpha += 4)
    picture->rgba[alpha] = 255;
  return picture;
}

TeResult<TePicture> TeSceneRenderer::read() {
  const TeGlTable& gl = m_context.gl();
  if (!m_resolved.framebuffer) {
    const BoundFramebuffer bound(gl, m_target.framebuffer);
    return m_context.readPixels(m_width, m_height);
  }
  const BoundFramebuffer bound(gl, m_resolved.framebuffer);
  gl.bindFramebuffer(GL_READ_FRAMEBUFFER, m_target.framebuffer);
  gl.blitFramebuffer(0, 0, m_width, m_height, 0, 0, m_width, m_height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.bindFramebuffer(GL_READ_FRAMEBUFFER, m_resolved.framebuffer);
  return m_context.readPixels(m_width, m_height);
}
