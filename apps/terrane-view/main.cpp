// terrane-view: flies over an Inventor scene or a terrain of Seamless Patches, in a window or into pictures.

#include "apps/common/TeAppLog.h"
#include "apps/common/TeExit.h"
#include "apps/terrane-view/TeViewHeadless.h"
#include "apps/terrane-view/TeViewWindow.h"
#include "nodes/TeNodes.h"

namespace {

const char* kName = "terrane-view";

int fail(TeExit status, const TeStatus& failed) {
  const std::string& message = failed.error().message;
  return teWasLogged(message) ? status : teExitWith(status, kName, message);
}

int run(const TeCommandLine& commandLine, const TeViewOptions& options) {
  const TeCommonOptions& common = commandLine.common();
  TeNodes::init();
  TeReport report(kName, commandLine.commandText());
  const TeResult<std::unique_ptr<TeViewSession>> session = TeViewSession::create(options, common);
  if (!session)
    return fail(TeExitUsage, session.error());
  const TeStatus shown =
      common.context == "window" ? teViewWindow(**session, report) : teViewHeadless(**session, report);
  if (!shown)
    return fail(TeExitFailure, shown);
  (*session)->describe(report);
  if (!common.report.empty())
    if (const TeStatus ok = report.write(common.report); !ok)
      return fail(TeExitFailure, ok);
  return TeExitSuccess;
}

} // namespace

extern "C" int teMain(int argc, char** argv) {
  TeCommandLine commandLine(kName, "Flies over an Inventor scene, or a terrain drawn by Seamless Patches.");
  TeViewOptions options;
  options.addTo(commandLine);
  if (const std::optional<int> status = commandLine.parse(argc, argv))
    return *status;
  if (const TeStatus ok = options.check(); !ok)
    return teExitWith(TeExitUsage, kName, ok.error().message);
  teStartAppLog(kName, commandLine.common().quiet);
  return run(commandLine, options);
}
