#include "apps/common/TeEngineRun.h"

#include "apps/common/TeAppLog.h"
#include "apps/common/TeExit.h"
#include "apps/common/TeHeadlessRun.h"
#include "apps/common/TeWindowRun.h"
#include "nodes/TeNodes.h"

#include <cstdio>

int teRunEngine(const TeCommandLine& commandLine, const TeEngineOptions& options, TeEngineApp& app) {
  const TeCommonOptions& common = commandLine.common();
  const std::string& name = commandLine.application();
  if (options.terrain.listGenerators) {
    std::fputs(TeGeneratorRegistry::instance().helpText().c_str(), stdout);
    return TeExitSuccess;
  }
  if (const TeStatus ok = options.check(common); !ok)
    return teExitWith(TeExitUsage, name, ok.error().message);
  teStartAppLog(name, common.quiet);
  TeNodes::init();

  TeReport report(name, commandLine.commandText());
  TeEngineSession session(name, options, common, app);
  if (const TeStatus ok = session.prepare(); !ok)
    return teExitWith(TeExitUsage, name, ok.error().message);
  if (const TeStatus ok = session.startRecording(); !ok)
    return teExitWith(TeExitFailure, name, ok.error().message);

  const TeStatus ran =
      common.context == "window" ? teRunInWindow(session, name, report) : teRunHeadless(session, report);
  if (!ran)
    return teExitWith(TeExitFailure, name, ran.error().message);
  if (const TeStatus ok = session.finish(); !ok)
    return teExitWith(TeExitFailure, name, ok.error().message);
  if (!common.report.empty()) {
    session.describe(report.json());
    if (const TeStatus ok = report.write(common.report); !ok)
      return teExitWith(TeExitFailure, name, ok.error().message);
  }
  return TeExitSuccess;
}
