// terrane-accuracy: what accuracy costs in time.

#include "apps/common/TeAppLog.h"
#include "apps/common/TeExit.h"
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
  TeAccuracyCommand* const commands[] = {&instancing, &lod,     &quality, &submission,
                                         &generation, &normals, &height,  &all};
  for (TeAccuracyCommand* command : commands)
    if (command->isChosen())
      return command->run();
  return TeExitUsage; // not reached: one is required
}
