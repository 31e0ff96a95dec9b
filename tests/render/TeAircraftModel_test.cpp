#include "engine/objects/TeAircraftModel.h"

#include "nodes/TeNodePtr.h"
#include "render/TeRenderTest.h"

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>

#include <cmath>
#include <string>

namespace {

constexpr TePicture::Pixel kMagenta = {255, 0, 255, 255};

class TeAircraftModelRenderTest : public TeRenderTest {
protected:
  /// The model from a direction; `bothSides`: of its faces, whichever way round they are.
  TePicture drawFrom(SbVec3f direction, bool bothSides, const std::string& name) {
    TeNodePtr<SoSeparator> scene(new SoSeparator);
    auto* camera = new SoPerspectiveCamera;
    direction.normalize();
    camera->position = direction * 16;
    camera->pointAt(SbVec3f(0, 0, 0.3f), SbVec3f(0, 0, 1));
    scene->addChild(camera);
    auto* sun = new SoDirectionalLight;
    sun->direction.setValue(0.5f, 0.6f, -1);
    scene->addChild(sun);
    if (bothSides) {
      auto* hints = new SoShapeHints;
      hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
      hints->shapeType = SoShapeHints::UNKNOWN_SHAPE_TYPE;
      hints->setOverride(TRUE);
      scene->addChild(hints);
    }
    scene->addChild(teAircraftModel(SbColor(0.1f, 0.3f, 0.9f)));
    return draw(scene.get(), 300, 200, name);
  }
};

} // namespace

// A face that is the wrong way round would be missing, and what is behind it would show.
TEST_F(TeAircraftModelRenderTest, IsClosedFromAllSides) {
  int colour = 0;
  int white = 0;
  for (int view = 0; view < 14; ++view) {
    const float around = float(view) * 0.4488f + 0.1f;
    const float up = view == 0 ? 0.0f : 0.9f * std::sin(float(view));
    const SbVec3f from(std::sin(around), -std::cos(around), up);
    const TePicture solid = drawFrom(from, false, "aircraft-" + std::to_string(view));
    const TePicture both = drawFrom(from, true, "");
    ASSERT_FALSE(solid.rgba.empty() || both.rgba.empty());
    int differ = 0;
    int body = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 300; ++x) {
        const TePicture::Pixel pixel = solid.pixel(x, y);
        differ += (pixel == kMagenta) != (both.pixel(x, y) == kMagenta);
        body += pixel != kMagenta;
        colour += pixel != kMagenta && pixel[2] > 2 * pixel[0] && pixel[2] > 40;
        white += pixel != kMagenta && std::abs(pixel[0] - pixel[2]) < 25;
      }
    EXPECT_LE(differ, 2) << "view " << view << ": but for rounding at an edge";
    EXPECT_GT(body, 500) << "view " << view;
  }
  EXPECT_GT(colour, 1000);
  EXPECT_GT(white, 10'000);
}
