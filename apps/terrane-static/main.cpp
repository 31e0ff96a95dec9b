// terrane-static: a block of patches of generated terrain or elevation data, in a window or as a picture.

#include "apps/common/TeAppLog.h"
#include "apps/common/TeAppWorld.h"
#include "apps/common/TeCommandLine.h"
#include "apps/common/TeExit.h"
#include "apps/common/TeProgressLine.h"
#include "apps/common/TeReport.h"
#include "apps/common/TeStopwatch.h"
#include "apps/terrane-static/TeStaticDrawing.h"
#include "apps/terrane-static/TeStaticOptions.h"
#include "apps/terrane-static/TeStaticScene.h"
#include "generators/TeGeneratorRegistry.h"
#include "nodes/TeNodes.h"
#include "nodes/TeSceneFile.h"

#include <Inventor/actions/SoGetPrimitiveCountAction.h>

#include <cstdio>

namespace {

const char* kName = "terrane-static";

void describe(const TeStaticBlock& block, const TeAppWorld& made, int triangles, TeReport& report) {
  auto& json = report.json();
  json["seed"] = made.world.seed;
  json["generator"] = made.description;
  json["samples"] = block.lattice().samples();
  json["spacing_m"] = block.lattice().spacing();
  json["patches"] = block.patches() * block.patches();
  json["centre_m"] = {block.centre().x, block.centre().y};
  json["side_m"] = block.rect().northEast.x - block.rect().southWest.x;
  json["height_minimum_m"] = block.minimum();
  json["height_maximum_m"] = block.maximum();
  json["triangles"] = triangles;
}

int trianglesOf(SoNode* scene) {
  SoGetPrimitiveCountAction count;
  count.apply(scene);
  return count.getTriangleCount();
}

/// Shows how far it has come; the line is gone before anything else is printed.
TeResult<TeStaticBlock> makeTerrain(const TeAppWorld& made, int patches, bool quiet) {
  TeProgressLine progress("Making terrain", quiet);
  return TeStaticBlock::build(made.world, made.centre, patches,
                              [&](int done, int total) { progress.update(double(done) / total); });
}

int run(const TeCommandLine& commandLine, const TeStaticOptions& options) {
  const TeCommonOptions& common = commandLine.common();
  TeReport report(kName, commandLine.commandText());

  const TeStopwatch opening;
  TeResult<TeAppWorld> made = TeAppWorld::create(options.terrain, options.block, common.seed);
  if (!made)
    return teExitWith(TeExitUsage, kName, made.error().message);
  made->centre += options.center;
  report.addTime("open", opening.seconds());

  const TeStopwatch building;
  const TeResult<TeStaticBlock> block = makeTerrain(*made, options.block, common.quiet);
  if (!block)
    return teExitWith(TeExitUsage, kName, block.error().message);
  report.addTime("terrain", building.seconds());

  const TeStopwatch modelling;
  TeNodes::init();
  const TeResult<TeNodePtr<SoSeparator>> scene =
      teStaticScene(*block, options, float(common.width) / float(common.height));
  if (!scene)
    return teExitWith(TeExitUsage, kName, scene.error().message);
  report.addTime("model", modelling.seconds());
  // A wireframe draws the terrain twice.
  const int triangles = trianglesOf(scene->get()) / (options.wireframe ? 2 : 1);
  describe(*block, *made, triangles, report);
  if (!common.quiet)
    std::printf("%d patches, %d triangles, heights %.1f to %.1f m\n", block->patches() * block->patches(),
                triangles, double(block->minimum()), double(block->maximum()));

  if (!options.exportFile.empty())
    if (const TeStatus ok = teWriteScene(scene->get(), options.exportFile); !ok)
      return teExitWith(TeExitFailure, kName, ok.error().message);
  if (const TeStatus ok = teDrawStatic(scene->get(), common, report); !ok)
    return teExitWith(TeExitFailure, kName, ok.error().message);
  if (!common.report.empty())
    if (const TeStatus ok = report.write(common.report); !ok)
      return teExitWith(TeExitFailure, kName, ok.error().message);
  return TeExitSuccess;
}

} // namespace

extern "C" int teMain(int argc, char** argv) {
  TeCommandLine commandLine(kName,
                            "Shows a block of fitting patches of terrain, generated or from elevation data.");
  TeStaticOptions options;
  options.addTo(commandLine);
  if (const std::optional<int> status = commandLine.parse(argc, argv))
    return *status;
  if (options.terrain.listGenerators) {
    std::fputs(TeGeneratorRegistry::instance().helpText().c_str(), stdout);
    return TeExitSuccess;
  }
  if (const TeStatus ok = options.terrain.check(); !ok)
    return teExitWith(TeExitUsage, kName, ok.error().message);
  teStartAppLog(kName, commandLine.common().quiet);
  return run(commandLine, options);
}
