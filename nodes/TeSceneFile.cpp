#include "nodes/TeSceneFile.h"

#include <Inventor/SoOutput.h>
#include <Inventor/actions/SoWriteAction.h>
#include <Inventor/nodes/SoNode.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace {

constexpr std::size_t kFirstBuffer = 1 << 16;

/// Coin itself writes at most eight digits of a float, which not all floats come back from.
class ExactOutput : public SoOutput {
public:
  using SoOutput::write;
  void write(const float value) override { writeShortest(value); }
  void write(const double value) override { writeShortest(value); }

private:
  template <class Real> void writeShortest(Real value) {
    char text[32] = {}; // 24 characters at most, and the end
    std::to_chars(text, text + sizeof text - 1, value);
    SoOutput::write(static_cast<const char*>(text));
  }
};

} // namespace

TeStatus teWriteScene(SoNode* scene, const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file)
    return TeError{path + ": cannot be written: " + std::strerror(errno)};
  // Coin does not say whether its own writing to a file failed: it writes into memory, we to the file.
  ExactOutput output;
  output.setBuffer(std::malloc(kFirstBuffer), kFirstBuffer, std::realloc);
  SoWriteAction action(&output);
  action.apply(scene);
  void* buffer = nullptr;
  std::size_t size = 0;
  const bool made = output.getBuffer(buffer, size);
  errno = 0;
  const bool written = made && std::fwrite(buffer, 1, size, file) == size;
  const bool closed = std::fclose(file) == 0;
  std::free(buffer);
  if (written && closed)
    return {};
  return TeError{path + ": cannot be written: " + (errno ? std::strerror(errno) : "not enough memory")};
}

std::string teBesideScene(const std::string& file, const std::string& folder) {
  const std::filesystem::path path(file);
  if (path.empty() || path.is_absolute() || folder.empty())
    return file;
  return (std::filesystem::path(folder) / path).string();
}
