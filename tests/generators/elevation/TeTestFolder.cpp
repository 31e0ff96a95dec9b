#include "generators/elevation/TeTestFolder.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

TeTestFolder::TeTestFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "terrane-test-XXXXXX").string();
  if (const char* made = mkdtemp(pattern.data()))
    m_path = made;
}

TeTestFolder::~TeTestFolder() {
  std::error_code ignored;
  if (!m_path.empty())
    std::filesystem::remove_all(m_path, ignored);
}

std::string TeTestFolder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(path(name), std::ios::binary) << bytes;
  return path(name);
}

std::string teReadFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

std::string teTestData(const std::string& name) {
  const char* folder = std::getenv("TERRANE_DATA");
  const std::string path = (folder ? std::string(folder) : TERRANE_SOURCE_DIR "/../shared/data") + "/" + name;
  if (std::filesystem::exists(path))
    return path;
  std::printf("test data %s is not there (set TERRANE_DATA)\n", path.c_str());
  return {};
}
