#include "apps/common/TeReport.h"

#include "generators/base/TeHash.h"
#include "generators/base/TeText.h"

#include <sys/resource.h>

#include <cerrno>
#include <cstring>
#include <fstream>

std::int64_t tePeakMemoryBytes() {
  // getrusage() would count what the process had before it became this program, too.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (std::int64_t kilobytes = 0; word == "VmHWM:" && status >> kilobytes)
      return kilobytes * 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t(usage.ru_maxrss) * 1024;
}

TeReport::TeReport(const std::string& application, const std::string& arguments) {
  m_json["application"] = application;
  m_json["version"] = TERRANE_VERSION;
  m_json["arguments"] = arguments;
}

void TeReport::addTime(const std::string& name, double seconds) { m_json["times_ms"][name] = seconds * 1000; }

void TeReport::addPicture(const TePicture& picture) {
  m_json["picture_size"] = {picture.width, picture.height};
  m_json["picture_hash"] = teHexText(teHashBytes(picture.rgba.data(), picture.rgba.size()));
}

TeStatus TeReport::write(const std::string& file) {
  // Beside those by kind, if the application has told any.
  auto& memory = m_json["memory_peak_bytes"];
  (memory.is_object() ? memory["process"] : memory) = tePeakMemoryBytes();
  std::ofstream stream(file);
  stream << m_json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  stream.close();
  if (!stream)
    return TeError{file + ": cannot be written: " + std::strerror(errno)};
  return {};
}
