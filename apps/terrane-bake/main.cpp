// terrane-bake: makes the files that large terrains are drawn from.

#include "apps/common/TeAppLog.h"
#include "apps/common/TeCommandLine.h"
#include "apps/common/TeExit.h"
#include "apps/common/TeReport.h"
#include "apps/terrane-bake/TeMipmaps.h"
#include "apps/terrane-bake/TeSynth.h"

#include <cstdlib>

namespace {

const char* kName = "terrane-bake";

} // namespace

int main(int argc, char** argv) {
  // Rows are read in order: GDAL needs room for one row of a file's blocks. A user's own choice stands.
  ::setenv("GDAL_CACHEMAX", "12", 0);
  TeCommandLine commandLine(kName, "Makes the files that large terrains are drawn from.", false);
  commandLine.cli().require_subcommand(1);
  commandLine.cli().fallthrough();
  TeMipmapsOptions mipmaps;
  TeSynthOptions synth;
  CLI::App* const mipmapsCommand = mipmaps.addTo(commandLine);
  synth.addTo(commandLine);
  if (const std::optional<int> status = commandLine.parse(argc, argv))
    return *status;
  const TeCommonOptions& common = commandLine.common();
  teStartAppLog(kName, common.quiet);
  TeReport report(kName, commandLine.commandText());
  const int status = mipmapsCommand->parsed() ? teBakeMipmaps(kName, mipmaps, common, report)
                                              : teBakeSynth(kName, synth, common, report);
  if (status != TeExitSuccess || common.report.empty())
    return status;
  if (const TeStatus ok = report.write(common.report); !ok)
    return teExitWith(TeExitFailure, kName, ok.error().message);
  return TeExitSuccess;
}
