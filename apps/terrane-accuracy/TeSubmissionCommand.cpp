#include "apps/terrane-accuracy/TeSubmissionCommand.h"

#include "apps/common/TeExit.h"
#include "apps/common/TeProgressLine.h"
#include "generators/base/TeText.h"
#include "nodes/lod/TeLodMethods.h"

#include <algorithm>
#include <cstdio>

namespace {

constexpr int kDefaultFrames = 11;
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
    : m_commandLine(commandLine),
      m_cli(commandLine.cli().add_subcommand(
          "submission",
          "Measures the ways to send the same triangles: vertex arrays, buffers, display lists")) {
  m_cli->fallthrough();
  m_terrain.addTo(*m_cli);
  const std::string group = "Measuring";
  m_cli
      ->add_option("--method", m_method,
                   "LOD method whose mesh is sent beside full grids (default: seamless)")
      ->check(CLI::IsMember(TeLodMethods::names()))
      ->option_text("NAME")
      ->group(group);
  m_cli->add_option("--px", m_pixels, "Its screen errors, pixels (default: 1,4)")
      ->delimiter(',')
      ->check(TeCommandLine::within(1e-3, 1e4))
      ->option_text("LIST")
      ->group(group);
  m_cli->add_option("--largest", m_largest, "Cells a side of the largest grid (default: 512)")
      ->transform(TeCommandLine::wholeWithin(kSmallestGrid, 4096))
      ->option_text("N")
      ->group(group);
  m_cli->add_option("--out", m_folder, "Folder for what is written (default: accuracy)")
      ->check(TeCommandLine::notEmpty())
      ->option_text("DIR")
      ->group(group);
}

int TeSubmissionCommand::frames() const {
  return m_commandLine.common().frames > 0 ? m_commandLine.common().frames : kDefaultFrames;
}

TeResult<std::vector<TeSubmissionMesh>> TeSubmissionCommand::meshes(const TeMeasuredTerrain& terrain) const {
  std::vector<TeSubmissionMesh> meshes;
  for (int cells = kSmallestGrid; cells <= std::min(m_largest, terrain.cells()); cells *= 2) {
    TeResult<TeSubmissionMesh> grid = TeSubmissionMesh::grid(terrain, cells);
    if (!grid)
      return grid.error();
    meshes.push_back(std::move(*grid));
  }
  TeFlyover flight = terrain.flyover();
  flight.width = m_commandLine.common().width;
  flight.height = m_commandLine.common().height;
  for (const double pixels : m_pixels) {
    TeResult<TeSubmissionMesh> mesh = TeSubmissionMesh::selected(terrain, flight, m_method, pixels);
    if (!mesh)
      return mesh.error();
    meshes.push_back(std::move(*mesh));
  }
  return meshes;
}

TeStatus TeSubmissionCommand::measure(const std::vector<TeSubmissionMesh>& meshes, TeFlightStage& stage,
                                      TeTable& table) const {
  TeProgressLine progress("Sending", m_commandLine.common().quiet);
  const double total = 2.0 * double(meshes.size()) * (frames() + 1);
  double done = 0;
  for (const TeSubmissionMesh& mesh : meshes)
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

void TeSubmissionCommand::describe(const TeMeasuredTerrain& terrain, const TeFlightStage& stage,
                                   const TeTable& table, TeAccuracyOutput& output) const {
  const TeCommonOptions& common = m_commandLine.common();
  auto& json = output.json();
  json["terrain"] = {{"file", terrain.name},
                     {"samples", terrain.cells() + 1},
                     {"spacing_m", terrain.spacing()},
                     {"height_unit_m", terrain.heightScale()}};
  json["frames"] = frames();
  json["width"] = common.width;
  json["height"] = common.height;
  json["context"] = common.context;
  json["renderer"] = stage.context().renderer();
  output.addText(
      teFormat("%s: full grids from above, and what %s selects for the first frame of the flyover; "
               "%d frames of %d×%d pixels in each way, in turn. ",
               terrain.name.c_str(), m_method.c_str(), frames(), common.width, common.height) +
      "Drawn by " + stage.context().renderer() + " (" + common.context + "). `ratio`: to vbo-static " +
      "of the same mesh and data. Static data is sent before the first frame that counts where its " +
      "way keeps it; changing data is another in each frame: static buffers and display lists are " +
      "then made anew, dynamic and stream buffers filled again.");
  output.addTable(table);
  output.addPlot(plotOf(table, false), "static");
  output.addPlot(plotOf(table, true), "changing");
}

int TeSubmissionCommand::run() {
  const std::string& application = m_commandLine.application();
  const TeCommonOptions& common = m_commandLine.common();
  TeAccuracyOutput output(m_commandLine, "submission", m_folder);
  const TeResult<TeMeasuredTerrain> terrain = m_terrain.read();
  if (!terrain)
    return teExitWith(TeExitUsage, application, terrain.error().message);
  const TeResult<std::vector<TeSubmissionMesh>> meshes = this->meshes(*terrain);
  if (!meshes)
    return teExitWith(TeExitUsage, application, meshes.error().message);
  if (const TeStatus ok = output.prepare(); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  const TeResult<std::unique_ptr<TeFlightStage>> stage =
      TeFlightStage::create(*teContextKind(common.context), common.width, common.height);
  if (!stage)
    return teExitWith(TeExitFailure, application, stage.error().message);

  TeTable table({"mesh", "data", "submission", "triangles", "vertices", "parts", "draw_calls", "frame_ms",
                 "frame_low_ms", "frame_high_ms", "ratio", "upload_bytes", "mesh_bytes"});
  if (const TeStatus ok = measure(*meshes, **stage, table); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  describe(*terrain, **stage, table, output);
  if (!common.quiet)
    std::fputs(table.markdown().c_str(), stdout);
  if (const TeStatus ok = output.write(table); !ok)
    return teExitWith(TeExitFailure, application, ok.error().message);
  return TeExitSuccess;
}
