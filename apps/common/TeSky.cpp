#include "apps/common/TeSky.h"

#include "nodes/TeOverlay.h"

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoPackedColor.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <cmath>

namespace {

constexpr int kColumns = 24;
constexpr int kRows = 16; ///< from kLowest to overhead
constexpr float kLowest = -0.1f;
constexpr float kHazy = 0.05f; ///< so far up it has the horizon's colour, that of hills in the haze
const SbColor kOverhead(0.22f, 0.42f, 0.72f);
constexpr float kPi = 3.14159265f;

float elevation(int row) { return kLowest + (kPi / 2 - kLowest) * float(row) / kRows; }

SbColor colourAt(float elevation, const SbColor& horizon) {
  const float height = std::clamp((elevation - kHazy) / (kPi / 2), 0.0f, 1.0f);
  const float share = height * (2 - height);
  return horizon * (1 - share) + kOverhead * share;
}

} // namespace

SoNode* teSky(SoPerspectiveCamera& camera, const SbColor& horizon) {
  auto* sky = new SoSeparator;
  auto* eye = new SoPerspectiveCamera;
  eye->position = SbVec3f(0, 0, 0);
  eye->nearDistance = 0.1f;
  eye->farDistance = 10;
  eye->heightAngle.connectFrom(&camera.heightAngle);
  eye->orientation.connectFrom(&camera.orientation);
  sky->addChild(eye);
  teAddOverlayState(*sky);

  auto* coordinates = new SoCoordinate3;
  auto* colours = new SoPackedColor;
  for (int row = 0; row <= kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const float up = elevation(row), around = 2 * kPi * float(column) / kColumns;
      const int number = row * kColumns + column;
      coordinates->point.set1Value(number, std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                                   std::sin(up));
      colours->orderedRGBA.set1Value(number, colourAt(up, horizon).getPackedValue());
    }
  sky->addChild(coordinates);
  sky->addChild(colours);
  auto* binding = new SoMaterialBinding;
  binding->value = SoMaterialBinding::PER_VERTEX_INDEXED;
  sky->addChild(binding);
  auto* strips = new SoIndexedTriangleStripSet;
  int at = 0;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) {
      strips->coordIndex.set1Value(at++, (row + 1) * kColumns + column % kColumns);
      strips->coordIndex.set1Value(at++, row * kColumns + column % kColumns);
    }
    strips->coordIndex.set1Value(at++, SO_END_STRIP_INDEX);
  }
  sky->addChild(strips);
  return sky;
}
