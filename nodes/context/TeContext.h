#pragma once

#include "nodes/TePicture.h"
#include "nodes/context/TeContextBackend.h"
#include "nodes/context/TeContextKind.h"
#include "nodes/context/TeGlTable.h"

#include <cstdint>
#include <memory>
#include <string>

/// An OpenGL context that Coin can draw with: RGBA8, 24 bits of depth, a drawable of a fixed size.
///
/// EGL and SoQt are modules that are loaded on first use. OSMesa works only if its library comes before all
/// other OpenGL in the program, because Coin binds to whoever is first: programs made by the CMake function
/// terrane_app() see to it; create() refuses elsewhere. Everything happens on one thread, the one that
/// created the context.
class TeContext {
public:
  /// Makes a context and makes it current. Sides 1 .. TePicture::kMaxSide. Error: no display, no device, a
  /// module that is not installed, a size out of range.
  static TeResult<std::unique_ptr<TeContext>> create(TeContextKind kind, int width, int height);
  /// Lets Coin's nodes free what they made in this context.
  ~TeContext();
  TeContext(const TeContext&) = delete;
  TeContext& operator=(const TeContext&) = delete;

  TeContextKind kind() const { return m_kind; }
  const char* name() const { return teContextName(m_kind); }
  int width() const { return m_width; }
  int height() const { return m_height; }
  /// The number under which Coin caches things for this context (SoGLRenderAction::setCacheContext).
  std::uint32_t id() const { return m_id; }
  /// GL_RENDERER and GL_VERSION.
  const std::string& renderer() const { return m_renderer; }
  const std::string& version() const { return m_version; }

  TeStatus makeCurrent();
  /// Shows what was drawn, if there is a window.
  void present() { m_backend->present(); }
  /// Functions of this context; call them while it is current.
  const TeGlTable& gl() const { return m_gl; }
  void* procAddress(const char* name) const { return m_backend->procAddress(name); }
  /// A rectangle of the bound framebuffer from its lower left corner; makes the context current.
  TeResult<TePicture> readPixels(int width, int height);

private:
  TeContext(TeContextKind kind, int width, int height, TeContextBackendPtr backend, const TeGlTable& gl);

  TeContextKind m_kind;
  int m_width;
  int m_height;
  std::uint32_t m_id;
  TeContextBackendPtr m_backend;
  TeGlTable m_gl;
  std::string m_renderer;
  std::string m_version;
};
