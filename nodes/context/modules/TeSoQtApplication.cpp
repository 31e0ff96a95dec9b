#include "nodes/context/modules/TeSoQtApplication.h"

#include "generators/base/TeLog.h"

#include <Inventor/Qt/SoQt.h>
#include <QString>
#include <QtGlobal>
#include <dlfcn.h>

#include <cstdlib>
#include <string>

namespace {

/// Whether the X server can be reached; asked through Xlib, which Qt's plugin loads as well.
TeStatus checkDisplay() {
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
    return TeError{"no display: the environment variable DISPLAY is not set"};
  void* xlib = dlopen("libX11.so.6", RTLD_NOW | RTLD_LOCAL);
  if (!xlib)
    return TeError{"no display: libX11.so.6 is not installed"};
  const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(xlib, "XOpenDisplay"));
  const auto close = reinterpret_cast<int (*)(void*)>(dlsym(xlib, "XCloseDisplay"));
  void* display = open && close ? open(nullptr) : nullptr;
  if (!display)
    return TeError{std::string("display '") + name + "' cannot be opened"};
  close(display);
  return {};
}

// SoQt would otherwise ask the user in a modal dialog.
void onFatalError(const SbString message, SoQt::FatalErrors, void*) {
  TeLog::error(std::string("window: ") + message.getString());
}

// Qt's remarks about the user's session are of no use to anyone who looks at terrain.
void onQtMessage(QtMsgType type, const QMessageLogContext&, const QString& message) {
  const std::string text = "window: " + message.toStdString();
  if (type == QtCriticalMsg || type == QtFatalMsg)
    TeLog::error(text);
  else
    TeLog::debug(text);
}

} // namespace

TeResult<QWidget*> TeSoQtApplication::start() {
  static QWidget* top = nullptr;
  if (top)
    return top;
  if (TeStatus status = checkDisplay(); !status)
    return status.error();
  qInstallMessageHandler(onQtMessage);
  SoQt::setFatalErrorHandler(onFatalError, nullptr);
  top = SoQt::init("Terrane", "Terrane");
  if (!top)
    return TeError{"SoQt cannot be started"};
  return top;
}
