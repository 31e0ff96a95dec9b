// terrane-accuracy submission: the same triangles in every way, and what each way sends.

#include "apps/TeAppRun.h"

#include <cmath>
#include <fstream>
#include <map>

namespace {

class TerraneAccuracySubmission : public TeAppRun {
protected:
  TerraneAccuracySubmission() : TeAppRun("terrane-accuracy") {}

  std::string hills() {
    const std::string file = scratch("hills.raw");
    std::ofstream stream(file, std::ios::binary);
    for (int y = 0; y < 129; y++)
      for (int x = 0; x < 129; x++) {
        const int height = int(20000 + 15000 * std::sin(x / 11.0) * std::cos(y / 7.0));
        stream.put(char(height & 255)).put(char(height >> 8));
      }
    return file;
  }
};

} // namespace

TEST_F(TerraneAccuracySubmission, EveryWaySendsTheSameMeshes) {
  const TeChildResult result = run({"submission", "--map", hills(), "--px", "8", "--frames", "2", "--size",
                                    "64x48", "--context", "osmesa", "--out", scratch("out")});
  ASSERT_EQ(result.status, 0) << result.error;
  std::ifstream stream(scratch("out") + "/submission.json");
  const nlohmann::json json = nlohmann::json::parse(stream);
  EXPECT_EQ(json["context"], "osmesa");
  // Grids of 65² and 129² samples and one selection; unchanged and changing; seven ways.
  ASSERT_EQ(json["rows"].size(), 3u * 2 * 7);
  std::map<std::string, nlohmann::json> triangles;
  for (const nlohmann::json& row : json["rows"]) {
    const std::string mesh = row["mesh"];
    EXPECT_EQ(triangles.try_emplace(mesh, row["triangles"]).first->second, row["triangles"]);
    const std::string way = row["submission"];
    const double sent = row["upload_bytes"];
    const bool changes = row["data"] == "changing";
    const bool keeps = way == "vbo-static" || way == "vbo-dynamic" || way == "display-lists";
    EXPECT_EQ(sent == 0, keeps && !changes) << row;
    if (sent > 0) {
      const double corners = 3 * 24 * row["triangles"].get<double>();
      EXPECT_EQ(sent, way == "immediate" ? corners : row["mesh_bytes"].get<double>()) << row;
    }
    if (way == "vbo-static") {
      EXPECT_EQ(row["ratio"], 1);
    }
    EXPECT_GT(row["frame_ms"], 0);
    EXPECT_EQ(row["draw_calls"], row["parts"]);
  }
  EXPECT_EQ(triangles["grid of 65² samples"], 2 * 64 * 64);
  EXPECT_EQ(triangles["grid of 129² samples"], 2 * 128 * 128);
}

TEST_F(TerraneAccuracySubmission, BadUsageIsOneLine) {
  EXPECT_EQ(run({"submission"}).status, 2);
  EXPECT_EQ(run({"submission", "--map", hills(), "--method", "magic"}).status, 2);
  EXPECT_EQ(run({"submission", "--map", scratch("nothing.raw")}).status, 2);
}
