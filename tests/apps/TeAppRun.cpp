#include "apps/TeAppRun.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

TeAppRun::TeAppRun(const std::string& program) : m_program(program) {
  std::string name = (fs::temp_directory_path() / (program + "-XXXXXX")).string();
  m_folder = mkdtemp(name.data());
}

TeAppRun::~TeAppRun() {
  std::error_code ignored;
  fs::remove_all(m_folder, ignored);
}

TeChildResult TeAppRun::run(const std::vector<std::string>& arguments, double seconds) const {
  std::vector<std::string> command = {TERRANE_BIN "/" + m_program};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return teRunChild(command, seconds, {}, {"DISPLAY"});
}

namespace {

/// Without the lines of a progress, which slow work shows before it fails.
std::string withoutProgress(const std::string& error) {
  std::istringstream lines(error);
  std::string rest;
  for (std::string line; std::getline(lines, line);)
    if (line.size() < 2 || line.compare(line.size() - 2, 2, " %") != 0)
      rest += line + '\n';
  return rest;
}

} // namespace

void TeAppRun::expectRefused(const std::vector<std::string>& arguments, int status,
                             const std::string& mentioned) const {
  const TeChildResult result = run(arguments, 20);
  const std::string text = testing::PrintToString(arguments);
  EXPECT_EQ(result.status, status) << text << "\n" << result.error;
  const std::string said = withoutProgress(result.error);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << text << "\n" << result.error;
  EXPECT_EQ(said.rfind(m_program + ": ", 0), 0u) << text << "\n" << result.error;
  EXPECT_NE(said.find(mentioned), std::string::npos) << text << "\n" << result.error;
}

TePicture TeAppRun::draw(std::vector<std::string> arguments, const std::string& context) {
  const std::string picture = scratch("picture.png"), report = scratch("report.json");
  arguments.insert(arguments.end(), {"--context", context, "--offscreen", picture, "--report", report});
  if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end())
    arguments.insert(arguments.end(), {"--size", "320x240"});
  std::vector<std::string> command = {TERRANE_BIN "/" + m_program};
  if (context == "window")
    command = {"xvfb-run", "-a", TERRANE_BIN "/" + m_program};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const TeChildResult result = teRunChild(command, 120, {}, {"DISPLAY"});
  EXPECT_EQ(result.status, 0) << result.error;
  std::ifstream stream(report);
  m_report = nlohmann::json::parse(stream, nullptr, false);
  EXPECT_FALSE(m_report.is_discarded());
  TeResult<TePicture> read = TePicture::readPng(picture);
  EXPECT_TRUE(read);
  return read ? std::move(*read) : TePicture();
}

std::string TeAppRun::data(const std::string& name) {
  const char* given = std::getenv("TERRANE_DATA");
  const fs::path folder = given ? fs::path(given) : fs::path(TERRANE_SOURCE_DIR) / "../shared/data";
  return fs::exists(folder / name) ? (folder / name).string() : std::string();
}

double teGroundShare(const TePicture& picture) {
  const TePicture::Pixel sky = picture.pixel(0, picture.height - 1);
  int ground = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      ground += picture.pixel(x, y) != sky;
  return double(ground) / (picture.width * picture.height);
}

double teDifferingShare(const TePicture& a, const TePicture& b, int most) {
  if (a.width != b.width || a.height != b.height)
    return 1;
  int differing = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const TePicture::Pixel p = a.pixel(x, y), q = b.pixel(x, y);
      bool differs = false;
      for (std::size_t channel = 0; channel < 3; ++channel)
        differs = differs || std::abs(int(p[channel]) - int(q[channel])) > most;
      differing += differs;
    }
  return double(differing) / (a.width * a.height);
}
