// terrane-accuracy: what accuracy costs in time.

#include "apps/common/TeAppLog.h"
#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeAllCommand.h"
#include "apps/terrane-accuracy/TeGenerationCommand.h"
#include "apps/terrane-accuracy/TeHeightCommand.h"
#include "apps/terrane-accuracy/TeInstancingCommand.h"
#include "apps/terrane-accuracy/TeLodCommand.h"
#include "apps/terrane-accuracy/TeNormalsCommand.h"
#include "apps/terrane-accuracy/TeQualityCommand.h"
#include "apps/terrane-accuracy/TeSubmissionCommand.h"
#include "nodes/TeNodes.h"

extern "C" int teMain(int argc, char** argv) {
  TeCommandLine commandLine("terrane-accuracy", "Measures what accuracy costs in time.");
  TeInstancingCommand instancing(commandLine);
  TeLodCommand lod(commandLine);
  TeQualityCommand quality(commandLine);
  TeSubmissionCommand submission(commandLine);
  TeGenerationCommand generation(commandLine);
  TeNormalsCommand normals(commandLine);
  TeHeightCommand height(commandLine);
  TeAllCommand all(commandLine, teMain);
  commandLine.cli().require_subcommand(1);
  if (const std::optional<int> status = commandLine.parse(argc, argv))
    return *status;
  teStartAppLog(commandLine.application(), commandLine.common().quiet);
  TeNodes::init();
  if (submission.cli().parsed())
    return submission.run();
  if (quality.cli().parsed())
    return quality.run();
  if (all.cli().parsed())
    return all.run();
  if (generation.cli().parsed())
    return generation.run();
  if (normals.cli().parsed())
    return normals.run();
  if (height.cli().parsed())
    return height.run();
  return instancing.cli().parsed() ? instancing.run() : lod.run();
}
