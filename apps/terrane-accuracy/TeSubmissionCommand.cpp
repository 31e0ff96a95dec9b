#include "apps/terrane-accuracy/TeSubmissionCommand.h"

#include "apps/common/TeProgressLine.h"
#include "generators/base/TeText.h"
#include "nodes/lod/TeLodMethods.h"

#include <algorithm>

namespace {

constexpr int kSmallestGrid = 64;
constexpr std::size_t kReference = 3; ///< vbo-static

const char* dataName(bool changes) { return changes ? "changing" : "static"; }

/// One curve a way: grids only, as the triangles of others do not fill the picture alike.
TePlot plotOf(const TeTable& table, bool changes) {
  TePlot plot;
  plot.title =
      std::string("Ways to send a full grid, data ") + (changes ? "changed each frame" : "unchanged");
  plot.xLabel = "triangles";
  plot.yLabel = "frame, ms (median)";
  for (const TeSubmissionWay& way : kTeSubmissionWays) {
    TePlot::Curve curve{way.name, {}, {}};
    for (std::size_t row = 0; row < table.rows(); row++) {
      if (std::get<std::string>(table.cell(row, "submission")) != way.name ||
          std::get<std::string>(table.cell(row, "data")) != dataName(changes) ||
          std::get<std::string>(table.cell(row, "mesh")).rfind("grid", 0) != 0)
        continue;
      curve.x.push_back(double(std::get<std::int64_t>(table.cell(row, "triangles"))));
      curve.y.push_back(table.number(row, "frame_ms"));
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

} // namespace

TeSubmissionCommand::TeSubmissionCommand(TeCommandLine& commandLine)
    : TeAccuracyCommand(
          commandLine, "submission",
          "Measures the ways to send the same triangles: vertex arrays, buffers, display lists") {
  m_choice.addTo(cli());
  cli()
      .add_option("--method", m_method, "LOD method whose mesh is sent beside full grids (default: seamless)")
      ->check(CLI::IsMember(TeLodMethods::names()))
      ->option_text("NAME")
      ->group(kGroup);
  addList("--px", m_pixels, TeCommandLine::within(1e-3, 1e4), "Its screen errors, pixels (default: 1,4)");
  addInteger("--largest", m_largest, kSmallestGrid, 4096, "Cells a side of the largest grid (default: 512)");
  addOutput();
}

TeStatus TeSubmissionCommand::read() {
  if (const TeStatus ok = keep(m_choice.read(), m_terrain); !ok)
    return ok;
  return keep(meshes(), m_meshes);
}

TeResult<std::vector<TeSubmissionMesh>> TeSubmissionCommand::meshes() const {
  const TeMeasuredTerrain& terrain = *m_terrain;
  std::vector<TeSubmissionMesh> meshes;
  for (int cells = kSmallestGrid; cells <= std::min(m_largest, terrain.cells()); cells *= 2) {
    TeResult<TeSubmissionMesh> grid = TeSubmissionMesh::grid(terrain, cells);
    if (!grid)
      return grid.error();
    meshes.push_back(std::move(*grid));
  }
  TeFlyover flight = terrain.flyover();
  flight.width = common().width;
  flight.height = common().height;
  for (const double pixels : m_pixels) {
    TeResult<TeSubmissionMesh> mesh = TeSubmissionMesh::selected(terrain, flight, m_method, pixels);
    if (!mesh)
      return mesh.error();
    meshes.push_back(std::move(*mesh));
  }
  return meshes;
}

TeStatus TeSubmissionCommand::sendAll(TeFlightStage& stage, TeTable& table) const {
  TeProgressLine progress("Sending", common().quiet);
  const double total = 2.0 * double(m_meshes->size()) * (frames() + 1);
  double done = 0;
  for (const TeSubmissionMesh& mesh : *m_meshes)
    for (const bool changes : {false, true}) {
      const auto measured = teMeasureSubmission(mesh, changes, frames(), stage,
                                                [&](int frame) { progress.update((done + frame) / total); });
      if (!measured)
        return measured.error();
      done += frames() + 1;
      for (std::size_t i = 0; i < kTeSubmissionWays.size(); i++) {
        const TeSubmissionFigures& figures = (*measured)[i];
        table.addRow({mesh.name, std::string(dataName(changes)), std::string(kTeSubmissionWays[i].name),
                      mesh.triangles(), mesh.vertices(), std::int64_t(mesh.parts.size()), figures.drawCalls,
                      figures.frameMs.median, figures.frameMs.low, figures.frameMs.high,
                      figures.frameMs.median / (*measured)[kReference].frameMs.median, figures.uploadBytes,
                      double(figures.bytes)});
      }
    }
  return {};
}

void TeSubmissionCommand::describe(const TeFlightStage& stage, const TeTable& table,
                                   TeAccuracyOutput& output) const {
  const TeMeasuredTerrain& terrain = *m_terrain;
  auto& json = output.json();
  json["terrain"] = {{"file", terrain.name},
                     {"samples", terrain.cells() + 1},
                     {"spacing_m", terrain.spacing()},
                     {"height_unit_m", terrain.heightScale()}};
  json["frames"] = frames();
  json["width"] = common().width;
  json["height"] = common().height;
  json["context"] = common().context;
  json["renderer"] = stage.context().renderer();
  output.addText(
      teFormat("%s: full grids from above, and what %s selects for the first frame of the flyover; "
               "%d frames of %d×%d pixels in each way, in turn. ",
               terrain.name.c_str(), m_method.c_str(), frames(), common().width, common().height) +
      "Drawn by " + stage.context().renderer() + " (" + common().context + "). `ratio`: to vbo-static " +
      "of the same mesh and data. Static data is sent before the first frame that counts where its " +
      "way keeps it; changing data is another in each frame: static buffers and display lists are " +
      "then made anew, dynamic and stream buffers filled again.");
  output.addTable(table);
  output.addPlot(plotOf(table, false), "static");
  output.addPlot(plotOf(table, true), "changing");
}

TeResult<TeTable> TeSubmissionCommand::measure(TeAccuracyOutput& output) {
  const TeResult<std::unique_ptr<TeFlightStage>> stage = makeStage();
  if (!stage)
    return stage.error();
  TeTable table({"mesh", "data", "submission", "triangles", "vertices", "parts", "draw_calls", "frame_ms",
                 "frame_low_ms", "frame_high_ms", "ratio", "upload_bytes", "mesh_bytes"});
  if (const TeStatus ok = sendAll(**stage, table); !ok)
    return ok.error();
  describe(**stage, table, output);
  return table;
}
