// terrane-accuracy as its users meet it: tables of the right columns, repeatable, and clear errors.

#include "apps/TeAppRun.h"
#include "nodes/lod/TeLodMethods.h"

#include <cmath>
#include <fstream>
#include <sstream>

namespace {

class TerraneAccuracy : public TeAppRun {
protected:
  TerraneAccuracy() : TeAppRun("terrane-accuracy") {}

  /// 129² samples of rough hills.
  std::string hills() {
    const std::string file = scratch("hills.raw");
    std::ofstream stream(file, std::ios::binary);
    for (int y = 0; y < 129; y++)
      for (int x = 0; x < 129; x++) {
        const int height = int(20000 + 15000 * std::sin(x / 11.0) * std::cos(y / 7.0) + 40 * (x * y % 23));
        stream.put(char(height & 255)).put(char(height >> 8));
      }
    return file;
  }

  static std::string contents(const std::string& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
};

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    all.push_back(line);
  return all;
}

/// A JSON report without what differs from run to run.
nlohmann::json repeatable(const std::string& text) {
  nlohmann::json json = nlohmann::json::parse(text);
  json.erase("memory_peak_bytes");
  json.erase("arguments");
  for (nlohmann::json& row : json["rows"])
    for (const char* name : {"select_ms", "select_low_ms", "select_high_ms", "frame_ms"})
      row.erase(name);
  return json;
}

TEST_F(TerraneAccuracy, LodMeasuresWhatItWrites) {
  const TeChildResult result = run(
      {"lod",       "--map",     hills(),    "--cells",  "10",        "--height-unit", "0.001",
       "--flyover", "--methods", "seamless", "--layout", "4/2",       "--px",          "1,8",
       "--dial",    "2",         "--frames", "3",        "--no-draw", "--out",         scratch("out/lod")});
  ASSERT_EQ(result.status, 0) << result.error;
  const std::vector<std::string> csv = lines(contents(scratch("out/lod/lod.csv")));
  ASSERT_EQ(csv.size(), 4u);
  EXPECT_EQ(csv[0].rfind("method,wanted_px,dial,triangles,select_ms,upload_bytes,frame_ms,worst_px,p999_px,"
                         "rms_px,worst_m,bound_px,uncovered,cracks,popping_px,bytes_per_sample",
                         0),
            0u)
      << csv[0];
  EXPECT_EQ(csv[1].rfind("seamless,1,", 0), 0u) << csv[1];
  EXPECT_EQ(csv[3].rfind("seamless,,2,", 0), 0u) << csv[3];

  const nlohmann::json json = nlohmann::json::parse(contents(scratch("out/lod/lod.json")));
  EXPECT_EQ(json["application"], "terrane-accuracy");
  EXPECT_EQ(json["terrain"]["samples"], 129);
  ASSERT_EQ(json["rows"].size(), 3u);
  for (const nlohmann::json& row : json["rows"]) {
    EXPECT_LE(row["worst_px"].get<double>(), row["bound_px"].get<double>() * 1.00001) << row;
    EXPECT_LE(row["rms_px"], row["worst_px"]) << row;
    EXPECT_LE(row["p999_px"], row["worst_px"]) << row;
    EXPECT_EQ(row["overshoots"], 0) << row;
    EXPECT_EQ(row["uncovered"], 0) << row;
    EXPECT_EQ(row["cracks"], 0) << row;
    EXPECT_GT(row["triangles"], 0) << row;
  }
  EXPECT_LE(json["rows"][0]["worst_px"], 1.00001);
  EXPECT_GT(json["rows"][0]["worst_px"], 0);
  EXPECT_GT(json["rows"][0]["triangles"], json["rows"][1]["triangles"]);
  EXPECT_NE(contents(scratch("out/lod/lod.md")).find("| method | wanted_px |"), std::string::npos);
}

TEST_F(TerraneAccuracy, LodMeasuresAllMethodsUnlessSomeAreNamed) {
  const TeChildResult result = run({"lod", "--map", hills(), "--layout", "4/2", "--px", "2", "--frames", "1",
                                    "--no-draw", "--quiet", "--out", scratch("all")});
  ASSERT_EQ(result.status, 0) << result.error;
  const nlohmann::json json = nlohmann::json::parse(contents(scratch("all/lod.json")));
  ASSERT_EQ(json["rows"].size(), TeLodMethods::names().size());
  for (std::size_t i = 0; i < json["rows"].size(); i++) {
    const nlohmann::json& row = json["rows"][i];
    EXPECT_EQ(row["method"], TeLodMethods::names()[i]);
    if (row["method"] != "rtin-midpoint") { // whose error is no bound
      EXPECT_LE(row["worst_px"].get<double>(), 2.00002) << row;
    }
    EXPECT_EQ(row["overshoots"], 0) << row;
    EXPECT_EQ(row["uncovered"], 0) << row;
    EXPECT_EQ(row["cracks"], 0) << row;
    EXPECT_GT(row["bytes_per_sample"], 2) << row;
  }
  EXPECT_EQ(json["rows"][0]["method"], "brute");
  EXPECT_EQ(json["rows"][0]["worst_px"], 0);
}

TEST_F(TerraneAccuracy, LodRepeatsButForTimes) {
  const std::string map = hills();
  for (const char* folder : {"a", "b"}) {
    const TeChildResult result =
        run({"lod", "--map", map, "--layout", "4/3", "--methods", "seamless-geomorph", "--px", "4",
             "--frames", "2", "--no-draw", "--out", scratch(folder)});
    ASSERT_EQ(result.status, 0) << result.error;
  }
  EXPECT_EQ(repeatable(contents(scratch("a/lod.json"))), repeatable(contents(scratch("b/lod.json"))));
}

TEST_F(TerraneAccuracy, ARunThatFailsLeavesEarlierTablesAlone) {
  const std::vector<std::string> lod = {"lod",      "--map", hills(),       "--methods", "seamless",
                                        "--layout", "4/2",   "--px",        "4",         "--frames",
                                        "1",        "--out", scratch("out")};
  std::vector<std::string> first = lod;
  first.push_back("--no-draw");
  ASSERT_EQ(run(first).status, 0);
  const std::string table = contents(scratch("out/lod.csv"));
  EXPECT_EQ(lines(table).size(), 2u);
  std::vector<std::string> second = lod;
  second.insert(second.end(), {"--context", "window"}); // there is no display
  EXPECT_EQ(run(second).status, 1);
  EXPECT_EQ(contents(scratch("out/lod.csv")), table);
}

TEST_F(TerraneAccuracy, LodDrawsBesidePlainOpenGl) {
  const TeChildResult result =
      run({"lod", "--map", hills(), "--methods", "seamless", "--layout", "4/2", "--px", "4", "--frames", "2",
           "--size", "64x48", "--context", "osmesa", "--quiet", "--out", scratch("drawn")});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, "");
  const nlohmann::json json = nlohmann::json::parse(contents(scratch("drawn/lod.json")));
  EXPECT_GT(json["rows"][0]["frame_ms"], 0);
  EXPECT_GT(json["rows"][0]["raw_frame_ms"], 0);
  EXPECT_GT(json["rows"][0]["frame_ratio"], 0);
  EXPECT_FALSE(json["renderer"].get<std::string>().empty());
}

TEST_F(TerraneAccuracy, InstancingNeedsFarFewerCallsForTheSameTriangles) {
  const TeChildResult result =
      run({"instancing",    "--map",    hills(),    "--cells", "10",
           "--height-unit", "0.01",     "--layout", "4/2",     "--precision",
           "1,4",           "--frames", "3",        "--size",  "64x48",
           "--context",     "osmesa",   "--quiet",  "--out",   scratch("instancing")});
  ASSERT_EQ(result.status, 0) << result.error;
  const nlohmann::json json = nlohmann::json::parse(contents(scratch("instancing/instancing.json")));
  ASSERT_EQ(json["rows"].size(), 6u);
  for (std::size_t i = 0; i < 6; i += 3) {
    const nlohmann::json& whole = json["rows"][i];
    const nlohmann::json& instanced = json["rows"][i + 1];
    const nlohmann::json& classic = json["rows"][i + 2];
    EXPECT_EQ(whole["method"], "whole");
    EXPECT_EQ(whole["triangles"], classic["triangles"]);
    EXPECT_LT(whole["draw_calls"], classic["draw_calls"]);
    EXPECT_EQ(instanced["method"], "instanced");
    EXPECT_EQ(classic["method"], "classic");
    EXPECT_EQ(instanced["triangles"], classic["triangles"]);
    EXPECT_GT(instanced["triangles"], 0);
    EXPECT_LT(instanced["draw_calls"], classic["draw_calls"]);
    EXPECT_GT(instanced["visited"], 1);
    EXPECT_GT(instanced["frame_ms"], 0);
    EXPECT_TRUE(instanced["document_draw_calls"].is_null()) << "only for the document's own resolution";
  }
  EXPECT_LT(json["rows"][0]["triangles"], json["rows"][3]["triangles"]);
  EXPECT_EQ(lines(contents(scratch("instancing/instancing.csv"))).size(), 7u);
}

TEST_F(TerraneAccuracy, InstancingFliesOverAPyramid) {
  // Levels 0 .. 9 of flat land: the whole of the lower ones and windows of 65 samples of the upper ones.
  for (int level = 0; level <= 9; level++) {
    const std::size_t side = (std::size_t(1) << level) + 1;
    std::ofstream(scratch("land_" + std::to_string(level) + ".raw")) << std::string(2 * side * side, 'a');
  }
  const TeChildResult result =
      run({"instancing", "--clipmaps", scratch("land"), "--clip-size", "65", "--layout", "4/2", "--precision",
           "2", "--frames", "2", "--no-draw", "--quiet", "--out", scratch("land")});
  ASSERT_EQ(result.status, 0) << result.error;
  const nlohmann::json json = nlohmann::json::parse(contents(scratch("land/instancing.json")));
  ASSERT_EQ(json["rows"].size(), 6u);
  EXPECT_EQ(json["rows"][0]["resolution"], 512);
  EXPECT_EQ(json["rows"][3]["resolution"], 128);
  EXPECT_TRUE(json["rows"][0]["frame_ms"].is_null());
  EXPECT_GT(json["rows"][0]["select_ms"], 0);
  EXPECT_GT(json["rows"][0]["plain_ns_a_visited"], 0);
}

TEST_F(TerraneAccuracy, HelpNamesTheOptions) {
  const TeChildResult all = run({"--help"});
  EXPECT_EQ(all.status, 0);
  EXPECT_NE(all.output.find("lod"), std::string::npos);
  EXPECT_NE(all.output.find("instancing"), std::string::npos);
  const TeChildResult lod = run({"lod", "--help"});
  EXPECT_EQ(lod.status, 0);
  for (const char* option : {"--map", "--cells", "--height-unit", "--dem", "--flyover", "--methods", "--px",
                             "--dial", "--geomorph", "--layout", "--stride", "--out", "--no-draw"})
    EXPECT_NE(lod.output.find(option), std::string::npos) << option;
}

TEST_F(TerraneAccuracy, BadUsageIsRefused) {
  const std::string map = hills();
  expectRefused({}, 2, "subcommand");
  expectRefused({"no-such"}, 2, "subcommand");
  expectRefused({"lod", "--no-draw"}, 2, "--map");
  expectRefused({"lod", "--map", scratch("none.raw")}, 2, "none.raw");
  expectRefused({"lod", "--map", scratch("")}, 2, "is no file");
  expectRefused({"lod", "--map", map, "--dem", map}, 2, "--dem");
  expectRefused({"lod", "--map", map, "--cells", "0"}, 2, "--cells");
  expectRefused({"lod", "--map", map, "--height-unit", "nan"}, 2, "--height-unit");
  expectRefused({"lod", "--map", map, "--px", "0"}, 2, "--px");
  expectRefused({"lod", "--map", map, "--px", "1,x"}, 2, "--px");
  expectRefused({"lod", "--map", map, "--dial", "x"}, 2, "--dial");
  expectRefused({"lod", "--map", map, "--dial", "0"}, 2, "--dial");
  expectRefused({"lod", "--map", map, "--layout", "4/2", "--dial", "seamless=0.5"}, 2, "dial 0.5");
  expectRefused({"lod", "--map", map, "--layout", "4/2", "--dial", "brute=2"}, 2, "brute");
  expectRefused({"lod", "--map", map, "--layout", "4/2", "--dial", "none=2"}, 2, "none");
  expectRefused({"lod", "--map", map, "--methods", "brute-geomorph"}, 2, "morph");
  expectRefused({"lod", "--map", map, "--methods", "roam9"}, 2, "--methods");
  expectRefused({"lod", "--map", map, "--layout", "16"}, 2, "--layout");
  expectRefused({"lod", "--map", map, "--layout", "3/2"}, 2, "--layout");
  expectRefused({"lod", "--map", map, "--stride", "0"}, 2, "--stride");
  expectRefused({"lod", "--map", map, "--layout", "4/2", "--no-draw", "--out", "/dev/null/x"}, 1,
                "/dev/null/x");
  expectRefused({"instancing"}, 2, "--clipmaps");
  expectRefused({"instancing", "--clipmaps", scratch("none")}, 2, "none");
  expectRefused({"instancing", "--clipmaps", "x", "--map", map}, 2, "--map");
  expectRefused({"instancing", "--map", map, "--layout", "16/99"}, 2, "99");
  expectRefused({"instancing", "--map", map, "--precision", "0"}, 2, "--precision");
  expectRefused({"instancing", "--map", map, "--clip-size", "513"}, 2, "--clip-size");
  const std::string odd = scratch("odd.raw");
  std::ofstream(odd) << "no square";
  expectRefused({"lod", "--map", odd}, 2, odd);
}

} // namespace
