#include "apps/terrane-view/TeViewStage.h"

#include "apps/common/TeHaze.h"
#include "apps/common/TeLight.h"
#include "apps/common/TeSky.h"
#include "engine/camera/TeClipRange.h"

#include <Inventor/nodes/SoOrthographicCamera.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr float kFieldOfView = 0.9f;  ///< radians, of the shorter side
constexpr double kHazeEnd = 0.9;      ///< of the content's size
constexpr double kTypicalSize = 1000; ///< smaller scenes have nearer planes in proportion
constexpr double kBehind = 0.3;       ///< of the content's size, from the first camera to the second
constexpr double kAbove = 0.45;
constexpr double kFrustumLength = 0.45;
constexpr double kFilled = 0.42; ///< 0.5 shows a sphere around the box

} // namespace

TeViewStage::TeViewStage(const TeViewContent& content, const TeViewOptions& options,
                         const TeCommonOptions& common)
    : m_content(content), m_all(new SoSeparator), m_scene(new SoSeparator), m_hudRoot(new SoSeparator),
      m_camera(new SoPerspectiveCamera), m_lodCamera(new SoPerspectiveCamera), m_style(new SoDrawStyle) {
  m_camera->heightAngle = m_content.heightAngle > 0 ? float(m_content.heightAngle) : kFieldOfView;
  m_lodCamera->heightAngle = m_camera->heightAngle;
  createScene(options);
  // A HUD without root or camera is a mistake in this file.
  const TeStatus attached = m_hud.attach(m_hudRoot.get(), new SoOrthographicCamera);
  assert(attached);
  static_cast<void>(attached);
  m_all->addChild(m_hudRoot.get());
  setSize(common.width, common.height);
}

void TeViewStage::createScene(const TeViewOptions& options) {
  if (options.sky)
    m_all->addChild(teSky(*m_camera, m_background));
  m_all->addChild(m_scene.get());
  if (options.haze)
    m_scene->addChild(teHaze(m_background, float(kHazeEnd * m_content.size())));
  m_scene->addChild(m_camera.get());
  if (!m_content.lit) {
    // The sun in the west, low enough that relief shows, and the sky.
    teAddLight(*m_scene, SbVec3f(0.75f, -0.2f, -0.6f), SbColor(1.0f, 0.96f, 0.88f), 0.95f);
    teAddLight(*m_scene, SbVec3f(0, 0, -1), SbColor(0.75f, 0.87f, 1.0f), 0.35f);
  }
  m_style->style.setIgnored(TRUE);
  m_style->pointSize.setIgnored(TRUE);
  m_style->lineWidth.setIgnored(TRUE);
  m_style->linePattern.setIgnored(TRUE);
  m_style->style = SoDrawStyle::LINES;
  m_scene->addChild(m_style.get());
  m_scene->addChild(m_content.root.get());
  m_scene->addChild(m_frustum.node());
}

void TeViewStage::setSize(int width, int height) {
  m_width = width;
  m_height = height;
  m_camera->aspectRatio = m_lodCamera->aspectRatio = float(width) / float(height);
  m_hud.setViewport(width, height);
}

void TeViewStage::setWireframe(bool on) {
  if (bool(m_style->style.isIgnored()) == !on)
    return;
  m_style->style.setIgnored(!on);
  m_style->setOverride(on);
}

TeViewPose TeViewStage::overview(const TeViewContent& content) {

  const double distance = kFilled * glm::length(content.high - content.low) / std::sin(0.5 * kFieldOfView);
  const glm::dvec3 away = glm::normalize(glm::dvec3(0.25, -0.8, 0.5)) * std::max(distance, 1e-6);
  return TeViewPose::towards(content.middle() + away, content.middle());
}

TeViewPose TeViewStage::secondPose(const TeViewPose& first) const {
  const double yaw = first.yaw(), size = m_content.size();
  const glm::dvec3 ahead(std::cos(yaw), std::sin(yaw), 0);
  const glm::dvec3 eye = first.eye - ahead * (kBehind * size) + glm::dvec3(0, 0, kAbove * size);
  return TeViewPose::towards(eye, first.eye + ahead * (kBehind * size));
}

/// Near and far as engine scenes have them, from the distance to the farthest of the content.
void TeViewStage::setPlanes(SoPerspectiveCamera& camera, const TeViewPose& pose) const {
  const glm::dvec3 far = glm::max(glm::abs(m_content.low - pose.eye), glm::abs(m_content.high - pose.eye));
  const std::optional<double> ground = m_content.ground->heightAt({pose.eye.x, pose.eye.y});
  // Outside, the box is as far away as its nearest point.
  const glm::dvec3 outside =
      glm::max(glm::max(m_content.low - pose.eye, pose.eye - m_content.high), glm::dvec3(0));
  const double height = std::max(ground ? pose.eye.z - *ground : 0, glm::length(outside));
  const double unit = std::min(1.0, m_content.size() / kTypicalSize);
  const TeClipRange range = TeClipRange::of(glm::length(far) / unit, height / unit, 0);
  camera.nearDistance = float(range.nearDistance * unit);
  camera.farDistance = float(range.farDistance * unit);
}

void TeViewStage::show(const TeViewPose& pose, bool secondCamera) {
  m_frustum.setShown(secondCamera);
  if (secondCamera) {
    pose.apply(*m_lodCamera);
    setPlanes(*m_lodCamera, pose);
    const double shorter = std::tan(0.5 * m_camera->heightAngle.getValue());
    const double wide = double(m_width) / m_height;
    m_frustum.set(pose, shorter * std::max(1.0, wide), shorter * std::max(1.0, 1 / wide),
                  kFrustumLength * m_content.size());
  }
  const TeViewPose drawn = secondCamera ? secondPose(pose) : pose;
  drawn.apply(*m_camera);
  setPlanes(*m_camera, drawn);
}
