#include "nodes/context/TeContext.h"

#include "generators/base/TeLog.h"
#include "generators/base/TeModule.h"

#include <Inventor/C/glue/gl.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/misc/SoContextHandler.h>

namespace {

std::string text(const TeGlTable& gl, GLenum what) {
  const GLubyte* bytes = gl.getString(what);
  return bytes ? reinterpret_cast<const char*>(bytes) : "";
}

// Coin asks GLX about every new context, and complains on standard error if there is no GLX.
void introduceToCoin(std::uint32_t id) {
  SoErrorCB* const handler = SoDebugError::getHandlerCallback();
  void* const data = SoDebugError::getHandlerData();
  SoDebugError::setHandlerCallback(
      [](const SoError* error, void*) { TeLog::debug(error->getDebugString().getString()); }, nullptr);
  cc_glglue_instance(int(id));
  SoDebugError::setHandlerCallback(handler, data);
}

} // namespace

TeResult<std::unique_ptr<TeContext>> TeContext::create(TeContextKind kind, int width, int height) {
  if (width < 1 || height < 1 || width > TePicture::kMaxSide || height > TePicture::kMaxSide)
    return TeError{"size " + std::to_string(width) + "x" + std::to_string(height) + ": sides must be 1 to " +
                   std::to_string(TePicture::kMaxSide)};
  const TeResult<void*> symbol =
      teModuleSymbol(std::string("context-") + teContextName(kind), "teCreateContext");
  if (!symbol)
    return symbol.error();
  using Create = void(int, int, TeResult<TeContextBackendPtr>*);
  TeResult<TeContextBackendPtr> backend = TeError{};
  reinterpret_cast<Create*> (*symbol)(width, height, &backend);
  if (!backend)
    return TeError{std::string("context ") + teContextName(kind) + ": " + backend.error().message};

  const TeResult<TeGlTable> gl =
      TeGlTable::load([&](const char* name) { return (*backend)->procAddress(name); });
  if (!gl)
    return TeError{std::string("context ") + teContextName(kind) + ": " + gl.error().message};
  return std::unique_ptr<TeContext>(new TeContext(kind, width, height, std::move(*backend), *gl));
}

TeContext::TeContext(TeContextKind kind, int width, int height, TeContextBackendPtr backend,
                     const TeGlTable& gl)
    : m_kind(kind), m_width(width), m_height(height), m_id(SoGLCacheContextElement::getUniqueCacheContext()),
      m_backend(std::move(backend)), m_gl(gl), m_renderer(text(gl, GL_RENDERER)),
      m_version(text(gl, GL_VERSION)) {
  introduceToCoin(m_id);
}

TeContext::~TeContext() {
  if (makeCurrent())
    SoContextHandler::destructingContext(m_id);
}

TeStatus TeContext::makeCurrent() { return m_backend->makeCurrent(); }

TeResult<TePicture> TeContext::readPixels(int width, int height) {
  if (width < 1 || height < 1 || width > TePicture::kMaxSide || height > TePicture::kMaxSide)
    return TeError{"pixels " + std::to_string(width) + "x" + std::to_string(height) + " cannot be read"};
  if (TeStatus status = makeCurrent(); !status)
    return status.error();
  TePicture picture;
  picture.width = width;
  picture.height = height;
  picture.rgba.resize(std::size_t(4) * width * height);
  m_gl.pixelStorei(GL_PACK_ALIGNMENT, 1);
  m_gl.readPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  return picture;
}
