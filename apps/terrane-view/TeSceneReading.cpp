#include "apps/terrane-view/TeSceneReading.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/errors/SoReadError.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace {

/// Keeps the first thing that Coin has to say about a file.
class FirstError {
public:
  FirstError() : m_handler(SoReadError::getHandlerCallback()), m_data(SoReadError::getHandlerData()) {
    SoReadError::setHandlerCallback(
        [](const SoError* error, void* text) {
          std::string& first = *static_cast<std::string*>(text);
          if (first.empty())
            first = error->getDebugString().getString();
        },
        &m_text);
  }
  ~FirstError() { SoReadError::setHandlerCallback(m_handler, m_data); }
  FirstError(const FirstError&) = delete;
  FirstError& operator=(const FirstError&) = delete;

  const std::string& text() const { return m_text; }

private:
  std::string m_text;
  SoErrorCB* m_handler;
  void* m_data;
};

} // namespace

TeResult<TeNodePtr<SoSeparator>> teReadScene(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return TeError{path + ": is a folder"};
  if (!std::ifstream(path))
    return TeError{path + ": cannot be read: " + std::strerror(errno)};
  const FirstError error;
  SoInput input;
  if (!input.openFile(path.c_str(), TRUE) || !input.isValidFile())
    return TeError{path + ": is no Inventor file"};
  TeNodePtr<SoSeparator> scene(SoDB::readAll(&input));
  if (!scene)
    return TeError{path + ": " + (error.text().empty() ? "cannot be read" : error.text())};
  return scene;
}
