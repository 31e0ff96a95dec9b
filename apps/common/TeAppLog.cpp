#include "apps/common/TeAppLog.h"

#include "generators/base/TeLog.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace {

spdlog::level::level_enum levelOf(TeLog::Level level) {
  switch (level) {
  case TeLog::Level::Debug:
    return spdlog::level::debug;
  case TeLog::Level::Info:
    return spdlog::level::info;
  case TeLog::Level::Warning:
    return spdlog::level::warn;
  case TeLog::Level::Error:
    break;
  }
  return spdlog::level::err;
}

std::string& lastError() {
  static std::string error;
  return error;
}

} // namespace

void teStartAppLog(const std::string& application, bool quiet) {
  auto logger =
      std::make_shared<spdlog::logger>(application, std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  logger->set_pattern("%n: %^%l%$: %v");
  logger->set_level(quiet ? spdlog::level::err : spdlog::level::info);
  TeLog::setSink([logger](TeLog::Level level, const std::string& message) {
    logger->log(levelOf(level), message);
    if (level == TeLog::Level::Error)
      lastError() = message;
  });
}

bool teWasLogged(const std::string& error) { return error == lastError(); }
