#include "apps/common/TeEngineRun.h"

#include "apps/common/TeAppLog.h"
#include "apps/common/TeExit.h"
#include "apps/common/TeHeadlessRun.h"
#include "apps/common/TeWindowRun.h"
#include "nodes/TeNodes.h"

#include <cstdio>

namespace {

int fail(TeExit status, const std::string& application, const TeStatus& failed) {
  const std::string& message = failed.error().message;
  return teWasLogged(message) ? status : teExitWith(status, application, message);
}

} // namespace

int teRunEngine(const TeCommandLine& commandLine, const TeEngineOptions& options, TeEngineApp& app) {
  const TeCommonOptions& common = commandLine.common();
  const std::string& name = commandLine.application();
  if (options.terrain.listGenerators) {
    std::fputs(TeGeneratorRegistry::instance().helpText().c_str(), stdout);
    return TeExitSuccess;
  }
  if (const TeStatus ok = options.check(common); !ok)
    return fail(TeExitUsage, name, ok);
  teStartAppLog(name, common.quiet);
  TeNodes::init();

  TeReport report(name, commandLine.commandText());
  TeEngineSession session(name, options, common, app);
  if (const TeStatus ok = session.prepare(); !ok)
    return fail(TeExitUsage, name, ok);
  if (const TeStatus ok = session.startRecording(); !ok)
    return fail(TeExitFailure, name, ok);

  const TeStatus ran =
      common.context == "window" ? teRunInWindow(session, name, report) : teRunHeadless(session, report);
  if (!ran)
    return fail(TeExitFailure, name, ran);
  if (const TeStatus ok = session.finish(); !ok)
    return fail(TeExitFailure, name, ok);
  if (!common.quiet)
    std::puts(session.summary().c_str());
  if (!common.report.empty()) {
    session.describe(report.json());
    if (const TeStatus ok = report.write(common.report); !ok)
      return fail(TeExitFailure, name, ok);
  }
  return TeExitSuccess;
}
