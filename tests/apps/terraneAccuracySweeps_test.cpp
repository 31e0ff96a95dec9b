// terrane-accuracy generation, normals, height and all, with settings so small that they take moments.

#include "apps/TeAppRun.h"

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace {

using Row = std::map<std::string, std::string>;

class TerraneAccuracySweeps : public TeAppRun {
protected:
  TerraneAccuracySweeps() : TeAppRun("terrane-accuracy") {}

  static std::string contents(const std::string& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  /// Cells in quotes may have commas.
  static std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char letter : line) {
      quoted = quoted != (letter == '"');
      if (letter == ',' && !quoted)
        cells.emplace_back();
      else if (letter != '"')
        cells.back() += letter;
    }
    return cells;
  }

  /// The rows of a CSV file, by column.
  static std::vector<Row> table(const std::string& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> columns = split(line);
    std::vector<Row> rows;
    while (std::getline(stream, line)) {
      const std::vector<std::string> cells = split(line);
      EXPECT_EQ(cells.size(), columns.size()) << line;
      rows.emplace_back();
      for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i)
        rows.back()[columns[i]] = cells[i];
    }
    return rows;
  }

  /// Runs twice into folders of the same name and expects all but times to be equal.
  std::vector<Row> sweep(const std::string& name, std::vector<std::string> arguments,
                         const std::vector<std::string>& times) {
    arguments.insert(arguments.begin(), name);
    std::vector<std::vector<Row>> runs;
    for (const char* folder : {"first", "second"}) {
      std::vector<std::string> all = arguments;
      all.insert(all.end(), {"--out", scratch(folder)});
      const TeChildResult result = run(all);
      EXPECT_EQ(result.status, 0) << result.error;
      runs.push_back(table(scratch(folder) + "/" + name + ".csv"));
      EXPECT_FALSE(runs.back().empty());
      for (Row& row : runs.back())
        for (const std::string& time : times) {
          EXPECT_GT(std::stod(row.at(time)), 0) << time;
          row.erase(time);
        }
      const nlohmann::json json = nlohmann::json::parse(contents(scratch(folder) + "/" + name + ".json"));
      EXPECT_EQ(json.at("rows").size(), runs.back().size());
      EXPECT_EQ(contents(scratch(folder) + "/" + name + ".md").rfind("## " + name, 0), 0u);
    }
    EXPECT_EQ(runs[0], runs[1]);
    return runs[0];
  }
};

double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

TEST_F(TerraneAccuracySweeps, GenerationComesNearerToItsReference) {
  const std::vector<Row> rows = sweep("generation", {"--samples-log", "5", "--maps", "2", "--runs", "2"},
                                      {"ms", "low_ms", "high_ms", "ratio"});
  std::map<std::string, double> first, last;
  for (const Row& row : rows) {
    const std::string name = row.at("generator");
    if (row.at("dial") == "arithmetic") {
      // Single precision and fixed point are near the plain formulas, but not at all the same.
      EXPECT_LT(number(row, "worst_of_relief"), 1e-4) << name;
      EXPECT_EQ(number(row, "worst_of_relief") == 0, row.at("arithmetic") == "double") << name;
      continue;
    }
    EXPECT_EQ(row.at("rms_of_relief").empty(), name == "circles");
    if (row.at("reference") == "yes") {
      EXPECT_EQ(number(row, "spectrum_db"), 0);
      continue;
    }
    const double error = number(row, row.at("rms_of_relief").empty() ? "spectrum_db" : "rms_of_relief");
    EXPECT_GT(error, 0) << name;
    first.emplace(name, error);
    last[name] = error;
  }
  ASSERT_EQ(first.size(), 5u);
  for (const auto& [name, error] : first)
    EXPECT_LT(last[name], 0.5 * error) << name;
}

TEST_F(TerraneAccuracySweeps, NormalsOfAllSamplesStayAsGoodAtCoarseLevels) {
  const std::vector<Row> rows = sweep("normals", {"--samples-log", "6", "--levels", "4", "--runs", "2"},
                                      {"ns", "low_ns", "high_ns", "ratio"});
  double fine = 0, coarse = 0, level0 = 0, face = 0;
  for (const Row& row : rows) {
    EXPECT_LE(number(row, "mean_deg"), number(row, "max_deg"));
    EXPECT_LE(number(row, "vertex_mean_deg"), number(row, "vertex_max_deg"));
    EXPECT_LE(number(row, "max_deg"), 180);
    if (row.at("terrain") != "formula")
      continue;
    if (row.at("way") == "central" && row.at("level") == "0")
      level0 = number(row, "vertex_mean_deg");
    if (row.at("way") == "one face" && row.at("level") == "0")
      face = number(row, "vertex_mean_deg");
    if (row.at("way") == "central" && row.at("level") == "3")
      (row.at("data") == "fine" ? fine : coarse) = number(row, "vertex_mean_deg");
  }
  EXPECT_GT(level0, 0);
  EXPECT_GT(face, 2 * level0);
  EXPECT_NEAR(fine, level0, 0.5 * level0);
  EXPECT_GT(coarse, 3 * fine);
}

TEST_F(TerraneAccuracySweeps, HeightsAreNoFartherOffThanTheySay) {
  const std::vector<Row> rows =
      sweep("height", {"--samples-log", "8", "--levels", "4", "--queries", "500", "--runs", "2"},
            {"ns", "low_ns", "high_ns", "ratio"});
  EXPECT_EQ(rows.size(), 3u * 4 + 1) << "heights in one call are of level 0";
  for (const Row& row : rows) {
    EXPECT_EQ(row.at("over"), "0");
    const bool base = row.at("level") == "0";
    EXPECT_EQ(number(row, "max_m") < 1e-6, base) << row.at("query");
    EXPECT_LE(number(row, "rms_m"), number(row, "max_m"));
    EXPECT_LE(number(row, "max_m"), number(row, "worst_bound_m") + 1e-6);
    if (base) {
      EXPECT_LE(number(row, "bytes_per_sample"), 6);
    }
  }
}

TEST_F(TerraneAccuracySweeps, FilesAndSizesThatDoNotFitAreRefused) {
  expectRefused({"height", "--map", scratch("none.raw"), "--out", scratch("out")}, 2, "none.raw");
  expectRefused({"normals", "--samples-log", "3"}, 2, "samples-log");
  expectRefused({"generation", "--generators", "sand"}, 2, "sand");
  expectRefused({"all", "--dem", scratch("none.tif"), "--out", scratch("out")}, 2, "none.tif");
}

TEST_F(TerraneAccuracySweeps, AllWritesAPageWithEveryPart) {
  const TeChildResult result = run({"all", "--quick", "--samples-log", "7", "--size", "64x48", "--context",
                                    "osmesa", "--quiet", "--out", scratch("docs"), "--work", scratch("work")},
                                   240);
  ASSERT_EQ(result.status, 0) << result.error;
  const std::string page = contents(scratch("docs/accuracy.md"));
  for (const std::string part :
       {"lod", "instancing", "submission", "quality", "generation", "normals", "height"}) {
    EXPECT_NE(page.find("[" + part + ".csv](accuracy/" + part + ".csv)"), std::string::npos) << part;
    EXPECT_FALSE(table(scratch("docs/accuracy/" + part + ".csv")).empty()) << part;
  }
  // Of frames only those of the run in the diagrams.
  std::set<std::string> runs, shownRuns;
  for (const Row& row : table(scratch("work/quality.csv")))
    runs.insert(row.at("run"));
  for (const Row& row : table(scratch("docs/accuracy/quality.csv")))
    shownRuns.insert(row.at("run"));
  EXPECT_EQ(runs.size(), 3u);
  EXPECT_EQ(shownRuns, std::set<std::string>{"simulated, exponent 1"});
  // Every diagram that is shown is there.
  for (std::size_t at = 0; (at = page.find("](images/accuracy/", at)) != std::string::npos; ++at) {
    const std::size_t end = page.find(')', at);
    EXPECT_TRUE(std::filesystem::exists(scratch("docs/" + page.substr(at + 2, end - at - 2))));
  }
  EXPECT_EQ(page.find(scratch("")), std::string::npos) << "names a folder of this machine";
}

} // namespace
