#pragma once

#include <string>

/// Collects what GDAL says on this thread for the life of the object, instead of letting it print.
class TeGdalErrors {
public:
  TeGdalErrors();
  ~TeGdalErrors();
  TeGdalErrors(const TeGdalErrors&) = delete;
  TeGdalErrors& operator=(const TeGdalErrors&) = delete;

  /// True if something failed (warnings do not count).
  bool failed() const { return !m_first.empty(); }
  /// The first failure in one line, or `otherwise`.
  std::string first(const std::string& otherwise) const { return m_first.empty() ? otherwise : m_first; }
  /// For the handler.
  void add(const char* message);

private:
  std::string m_first;
};
