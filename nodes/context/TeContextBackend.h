#pragma once

#include "generators/base/TeResult.h"

#include <memory>

/// What a context module implements: one OpenGL context (compatibility profile, RGBA8, 24 bits of depth) with
/// a drawable of a fixed size. Programs use TeContext.
///
/// Each module exports `extern "C" void teCreateContext(int width, int height,
/// TeResult<std::unique_ptr<TeContextBackend>>* result)`, which leaves the new context current.
class TeContextBackend {
public:
  virtual ~TeContextBackend() = default;
  virtual TeStatus makeCurrent() = 0;
  /// Address of a GL function; null if there is none.
  virtual void* procAddress(const char* name) const = 0;
  /// Shows what was drawn; nothing to do without a window.
  virtual void present() {}
};

using TeContextBackendPtr = std::unique_ptr<TeContextBackend>;
