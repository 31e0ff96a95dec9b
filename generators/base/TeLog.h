#pragma once

#include <functional>
#include <string>

/// The one way in which the libraries say anything by themselves. Without a sink nothing is written.
class TeLog {
public:
  enum class Level { Debug, Info, Warning, Error };
  using Sink = std::function<void(Level, const std::string&)>;

  /// Replaces the sink; an empty one silences the log. Thread-safe; a sink may be called from any thread,
  /// one call at a time, and must not use the log itself.
  static void setSink(Sink sink);

  static void write(Level level, const std::string& message);
  static void debug(const std::string& message) { write(Level::Debug, message); }
  static void info(const std::string& message) { write(Level::Info, message); }
  static void warning(const std::string& message) { write(Level::Warning, message); }
  static void error(const std::string& message) { write(Level::Error, message); }
};
