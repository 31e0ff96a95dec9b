#include "apps/terrane-accuracy/TeFlightStage.h"

#include "apps/common/TeLight.h"

#include <chrono>

TeResult<std::unique_ptr<TeFlightStage>> TeFlightStage::create(TeContextKind kind, int width, int height) {
  TeResult<std::unique_ptr<TeContext>> context = TeContext::create(kind, width, height);
  if (!context)
    return context.error();
  TeResult<std::unique_ptr<TeSceneRenderer>> renderer = TeSceneRenderer::create(**context, width, height);
  if (!renderer)
    return renderer.error();
  return std::unique_ptr<TeFlightStage>(new TeFlightStage(std::move(*context), std::move(*renderer)));
}

TeFlightStage::TeFlightStage(std::unique_ptr<TeContext> context, std::unique_ptr<TeSceneRenderer> renderer)
    : m_context(std::move(context)), m_renderer(std::move(renderer)), m_scene(new SoSeparator),
      m_camera(new SoPerspectiveCamera) {
  m_renderer->setFitClipPlanes(false);
  m_scene->renderCaching = SoSeparator::OFF;
  m_scene->addChild(m_camera);
  teAddLight(*m_scene, SbVec3f(0.8f, -0.3f, -0.5f), SbColor(1, 1, 1), 1.0f);
}

void TeFlightStage::show(SoNode* terrain) {
  constexpr int kBefore = 2; // camera and light
  while (m_scene->getNumChildren() > kBefore)
    m_scene->removeChild(kBefore);
  m_scene->addChild(terrain);
}

void TeFlightStage::lookFrom(const TePerspectiveView& view) {
  const glm::dvec3 right = view.right();
  const glm::dvec3 up = view.up();
  SbMatrix rotation = SbMatrix::identity();
  for (int axis = 0; axis < 3; axis++) {
    rotation[0][axis] = float(right[axis]);
    rotation[1][axis] = float(up[axis]);
    rotation[2][axis] = float(-view.forward[axis]);
  }
  m_camera->position.setValue(float(view.eye.x), float(view.eye.y), float(view.eye.z));
  m_camera->orientation = SbRotation(rotation);
  m_camera->heightAngle = float(view.fieldOfView);
  m_camera->nearDistance = float(view.nearDistance);
  m_camera->farDistance = float(view.farDistance);
}

TeResult<double> TeFlightStage::draw(const TePerspectiveView& view) {
  lookFrom(view);
  const auto start = std::chrono::steady_clock::now();
  if (const TeStatus ok = m_renderer->draw(m_scene.get()); !ok)
    return ok.error();
  m_context->gl().finish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

TeResult<TePicture> TeFlightStage::picture(const TePerspectiveView& view) {
  lookFrom(view);
  return m_renderer->render(m_scene.get());
}
