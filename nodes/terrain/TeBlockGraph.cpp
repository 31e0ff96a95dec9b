#include "nodes/terrain/TeBlockGraph.h"

#include "nodes/TePatchGraphBuilder.h"

#include <Inventor/nodes/SoScale.h>

#include <cmath>

TeResult<TeNodePtr<SoSeparator>> teBlockGraph(const TeStaticBlock& block, const TeBlockStyle& style) {
  if (!std::isfinite(style.verticalScale) || style.verticalScale <= 0)
    return TeError{"vertical scale " + std::to_string(style.verticalScale) + " is not finite and positive"};
  TePatchGraphBuilder builder(block.centre());
  builder.setColours(style.colours.value_or(TeSurfaceColours::forHeights(block.mean(), block.maximum())));
  builder.setShowParts(style.showParts);
  if (style.image) {
    if (TeStatus status = builder.setImage(*style.image, block.rect()); !status)
      return status.error();
  }

  TeNodePtr<SoSeparator> root(new SoSeparator);
  if (style.verticalScale != 1) {
    auto* scale = new SoScale;
    scale->scaleFactor.setValue(1, 1, style.verticalScale);
    root->addChild(scale);
  }
  const TeStatus built =
      block.forEachPiece([&](const TePatchMesh& mesh) { root->addChild(builder.build(mesh).get()); });
  if (!built)
    return built.error();
  if (style.water)
    root->addChild(builder.water(block.drawnRect(), *style.water).get());
  return root;
}
