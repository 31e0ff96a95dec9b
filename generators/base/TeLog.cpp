#include "generators/base/TeLog.h"

#include <mutex>

namespace {
std::mutex sinkMutex;
TeLog::Sink& currentSink() {
  static TeLog::Sink sink;
  return sink;
}
} // namespace

void TeLog::setSink(Sink sink) {
  std::lock_guard<std::mutex> lock(sinkMutex);
  currentSink() = std::move(sink);
}

void TeLog::write(Level level, const std::string& message) {
  std::lock_guard<std::mutex> lock(sinkMutex);
  if (currentSink())
    currentSink()(level, message);
}
