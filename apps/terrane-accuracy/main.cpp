// terrane-accuracy: what accuracy costs in time.

#include "apps/common/TeAppLog.h"
#include "apps/common/TeCommandLine.h"
#include "apps/terrane-accuracy/TeInstancingCommand.h"
#include "apps/terrane-accuracy/TeLodCommand.h"
#include "apps/terrane-accuracy/TeQualityCommand.h"
#include "apps/terrane-accuracy/TeSubmissionCommand.h"
#include "nodes/TeNodes.h"

extern "C" int teMain(int argc, char** argv) {
  TeCommandLine commandLine("terrane-accuracy", "Measures what accuracy costs in time.");
  TeInstancingCommand instancing(commandLine);
  TeLodCommand lod(commandLine);
  TeQualityCommand quality(commandLine);
  TeSubmissionCommand submission(commandLine);
  commandLine.cli().require_subcommand(1);
  if (const std::optional<int> status = commandLine.parse(argc, argv))
    return *status;
  teStartAppLog(commandLine.application(), commandLine.common().quiet);
  TeNodes::init();
  if (submission.cli().parsed())
    return submission.run();
  if (quality.cli().parsed())
    return quality.run();
  return instancing.cli().parsed() ? instancing.run() : lod.run();
}
