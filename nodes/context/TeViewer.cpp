#include "nodes/context/TeViewer.h"

#include "generators/base/TeModule.h"

TeResult<TeViewerSession> teRunViewer(SoNode* scene, const TeViewerOptions& options) {
  const TeResult<void*> symbol = teModuleSymbol("context-window", "teRunSoQtViewer");
  if (!symbol)
    return symbol.error();
  using Run = void(SoNode*, const TeViewerOptions&, TeResult<TeViewerSession>*);
  TeResult<TeViewerSession> session = TeViewerSession();
  reinterpret_cast<Run*> (*symbol)(scene, options, &session);
  return session;
}
