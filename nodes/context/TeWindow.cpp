#include "nodes/context/TeWindow.h"

#include "generators/base/TeModule.h"

TeWindow::~TeWindow() = default;

TeWindowClient::~TeWindowClient() = default;

TeResult<TeViewerSession> teRunWindow(SoNode* scene, const TeViewerOptions& options, TeWindowClient& client) {
  const TeResult<void*> symbol = teModuleSymbol("context-window", "teRunSoQtWindow");
  if (!symbol)
    return symbol.error();
  using Run = void(SoNode*, const TeViewerOptions&, TeWindowClient&, TeResult<TeViewerSession>*);
  TeResult<TeViewerSession> session = TeViewerSession();
  reinterpret_cast<Run*> (*symbol)(scene, options, client, &session);
  return session;
}
