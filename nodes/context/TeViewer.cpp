#include "nodes/context/TeViewer.h"

#include "generators/base/TeModule.h"

TeStatus teRunViewer(SoNode* scene, const TeViewerOptions& options) {
  const TeResult<void*> symbol = teModuleSymbol("context-window", "teRunSoQtViewer");
  if (!symbol)
    return symbol.error();
  using Run = void(SoNode*, const TeViewerOptions&, TeStatus*);
  TeStatus status;
  reinterpret_cast<Run*> (*symbol)(scene, options, &status);
  return status;
}
