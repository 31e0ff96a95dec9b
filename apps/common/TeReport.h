#pragma once

#include "generators/base/TeResult.h"
#include "nodes/TePicture.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

/// The JSON report of an application: one object, filled while it works.
class TeReport {
public:
  TeReport(const std::string& application, const std::string& arguments);

  nlohmann::ordered_json& json() { return m_json; }
  /// Adds a time under "times_ms".
  void addTime(const std::string& name, double seconds);
  /// Adds its size and the hash of its pixels.
  void addPicture(const TePicture& picture);
  /// Writes the file, with the process's peak memory added.
  TeStatus write(const std::string& file);

private:
  nlohmann::ordered_json m_json;
};

/// The largest resident memory of this process so far, bytes.
std::int64_t tePeakMemoryBytes();
