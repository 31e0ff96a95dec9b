// Every page of docs/ and the README: their examples are those that are compiled here, their links lead
// somewhere.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = TERRANE_SOURCE_DIR;

std::vector<std::string> linesOf(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found = {kRoot / "README.md"};
  for (const auto& entry : fs::directory_iterator(kRoot / "docs"))
    if (entry.path().extension() == ".md")
      found.push_back(entry.path());
  return found;
}

/// Without the blanks that all lines start with.
std::vector<std::string> dedented(std::vector<std::string> lines) {
  std::size_t indent = std::string::npos;
  for (const std::string& line : lines)
    if (const std::size_t first = line.find_first_not_of(' '); first != std::string::npos)
      indent = std::min(indent, first);
  for (std::string& line : lines)
    line.erase(0, std::min(indent, line.find_first_not_of(' ')));
  return lines;
}

/// The lines between the two `//! [name]` of a source file.
std::vector<std::string> snippet(const fs::path& file, const std::string& name) {
  std::vector<std::string> found;
  bool inside = false;
  for (const std::string& line : linesOf(file)) {
    if (line.find("//! [" + name + "]") != std::string::npos) {
      if (inside)
        return dedented(found);
      inside = true;
    } else if (inside) {
      found.push_back(line);
    }
  }
  ADD_FAILURE() << file << " has no example [" << name << "] between two markers";
  return {};
}

TEST(Docs, ExamplesAreThoseThatAreCompiled) {
  static const std::regex marker("<!-- example: (\\S+) (\\S+) -->");
  int compared = 0;
  for (const fs::path& page : pages()) {
    const std::vector<std::string> lines = linesOf(page);
    std::smatch match;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!std::regex_search(lines[i], match, marker))
        continue;
      const std::string file = match[1], name = match[2];
      ASSERT_LT(i + 1, lines.size());
      ASSERT_EQ(lines[i + 1].substr(0, 3), "```") << page << ": " << lines[i];
      std::vector<std::string> shown;
      for (i += 2; i < lines.size() && lines[i] != "```"; ++i)
        shown.push_back(lines[i]);
      EXPECT_EQ(dedented(shown), snippet(kRoot / file, name)) << page << ", example " << name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 0);
}

TEST(Docs, EveryCppFenceIsAnExample) {
  static const std::regex marker("<!-- example: \\S+ \\S+ -->");
  for (const fs::path& page : pages()) {
    const std::vector<std::string> lines = linesOf(page);
    for (std::size_t i = 0; i < lines.size(); ++i)
      EXPECT_TRUE(lines[i] != "```cpp" || (i > 0 && std::regex_search(lines[i - 1], marker)))
          << page << ":" << i + 1;
  }
}

TEST(Docs, LinksLeadSomewhere) {
  static const std::regex link("\\]\\(([^)#:]+)(#[^)]*)?\\)");
  for (const fs::path& page : pages()) {
    bool code = false;
    for (const std::string& line : linesOf(page)) {
      code = code != (line.rfind("```", 0) == 0);
      for (std::sregex_iterator it(line.begin(), line.end(), link), end; !code && it != end; ++it)
        EXPECT_TRUE(fs::exists(page.parent_path() / std::string((*it)[1]))) << page << ": " << (*it)[1];
    }
  }
}

} // namespace
