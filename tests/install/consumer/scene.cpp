// A Coin program: a patch and its seams as a scene graph.
#include "engine/TeEngine.h"

#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/nodes/SoSeparator.h>

#include <cstdio>

int main() {
  SoDB::init();
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64.0f, 64.0f));
  TePatch* west = engine.getPatch(SbVec2f(0.0f, 0.0f));
  TePatch* east = engine.getPatch(SbVec2f(32.0f, 0.0f));
  for (TePatch* patch : {west, east})
    if (!patch || !patch->prepareBuildMaps() || !patch->buildHMapFromBuildMaps()) {
      std::fprintf(stderr, "%s\n", engine.lastError().c_str());
      return 1;
    }
  SoSeparator* root = new SoSeparator;
  root->ref();
  root->addChild(west->getPatchGraph());
  root->addChild(east->getPatchGraph());
  root->addChild(west->getSeamGraph(TePatch::EAST));
  SoGetPrimitiveCountAction count;
  count.apply(root);
  std::printf("triangles %d\n", count.getTriangleCount());
  root->unref();
  return count.getTriangleCount() > 0 ? 0 : 1;
}
