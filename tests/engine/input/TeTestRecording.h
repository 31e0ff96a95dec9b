#pragma once

#include "engine/input/TeRecordingFormat.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

/// A folder for one test's recordings, removed in the end, and a run to record.
class TeTestRecording {
public:
  TeTestRecording() {
    static int count = 0;
    m_folder = std::filesystem::temp_directory_path() /
               ("terrane-recording-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(m_folder);
  }
  ~TeTestRecording() {
    std::error_code ignored;
    std::filesystem::remove_all(m_folder, ignored);
  }
  TeTestRecording(const TeTestRecording&) = delete;
  TeTestRecording& operator=(const TeTestRecording&) = delete;

  std::string path(const std::string& name) const { return (m_folder / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  static std::string read(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  /// Files in the folder.
  int files() const {
    return int(
        std::distance(std::filesystem::directory_iterator(m_folder), std::filesystem::directory_iterator()));
  }
  const std::filesystem::path& folder() const { return m_folder; }

  TeRecordingFormat::Settings settings{
      {"generator", "noise:type=ridged + band(0.5)"}, {"seed", "18446744073709551615"}, {"empty", ""}};
  std::vector<TeRecordedFrame> frames{
      {1.0 / 30, {{SoKeyboardEvent::UP_ARROW, true}, {SoKeyboardEvent::A, true, true, true, true}}, 0x0123u},
      {0.1, {}, ~std::uint64_t(0)},
      {0, {{SoKeyboardEvent::A, false, false, true}}, {}},
      {5e-324, {{SoKeyboardEvent::Key(0x1a2b), true}}, 0u},
  };

private:
  std::filesystem::path m_folder;
};
