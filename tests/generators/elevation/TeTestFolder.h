#pragma once

#include <string>

/// A folder for the files of one test, removed with everything in it at the end.
class TeTestFolder {
public:
  TeTestFolder();
  ~TeTestFolder();
  TeTestFolder(const TeTestFolder&) = delete;
  TeTestFolder& operator=(const TeTestFolder&) = delete;

  std::string path(const std::string& name) const { return m_path + "/" + name; }
  /// Writes a file of that name and tells its path.
  std::string write(const std::string& name, const std::string& bytes) const;

private:
  std::string m_path;
};

/// The whole file; empty if there is none.
std::string teReadFile(const std::string& path);
/// Path of a file of the test data (environment variable TERRANE_DATA, default ../shared/data beside the
/// sources); empty, with a message, if it is not there.
std::string teTestData(const std::string& name);
