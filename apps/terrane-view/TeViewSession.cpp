#include "apps/terrane-view/TeViewSession.h"

#include "apps/common/TeScreenshots.h"
#include "apps/terrane-view/TeViewText.h"

#include <algorithm>

namespace {

/// Of a frame; the rest is a margin, so that few frames are late.
constexpr double kDrawingShare = 0.9;

} // namespace

TeResult<std::unique_ptr<TeViewSession>> TeViewSession::create(const TeViewOptions& options,
                                                               const TeCommonOptions& common) {
  std::unique_ptr<TeViewSession> session(new TeViewSession(options, common));
  TeResult<TeViewContent> content = TeViewContent::create(options, common.quiet);
  if (!content)
    return content.error();
  session->m_content = std::move(*content);
  TeResult<TeViewFlight> flight = TeViewFlight::create(session->m_content, options);
  if (!flight)
    return flight.error();
  session->m_flight = std::make_unique<TeViewFlight>(std::move(*flight));
  session->m_stage = std::make_unique<TeViewStage>(session->m_content, options, common);
  session->m_nodes = std::make_unique<TeLodNodes>(session->m_content.root.get(), options);
  session->m_controls = std::make_unique<TeViewControls>(options, *session->m_nodes);
  if (const TeStatus ok = session->startQuality(); !ok)
    return ok.error();
  session->m_stage->hud().setHelp(teViewHelp());
  session->advance(0);
  return session;
}

void TeViewSession::advance(double dt) {
  if (dt > 0 && !m_controls->paused())
    m_flight->update(dt);
  m_stage->setWireframe(m_controls->wireframe());
  m_nodes->setLodCamera(m_controls->secondCamera() ? m_stage->lodCamera() : nullptr);
  m_stage->show(m_flight->pose(), m_controls->secondCamera());
  updateText();
}

void TeViewSession::updateText() {
  TeHud& hud = m_stage->hud();
  hud.setVisible(m_controls->statistics() || m_controls->help());
  hud.showHelp(m_controls->help());
  if (m_controls->statistics())
    hud.setLines(teViewLines(*m_nodes, m_flight->pose(), m_frameSeconds));
}

void TeViewSession::heard(const TeKeyEvent& event) {
  if (event.down && event.key == SoKeyboardEvent::ESCAPE)
    m_ended = true;
  else if (event.down && (event.key == SoKeyboardEvent::F12 || event.key == SoKeyboardEvent::G))
    m_pictureWanted = true;
  else if (!m_controls->handleKey(event) && m_flight->camera())
    m_flight->camera()->handleKey(event);
}

/// Runs that repeat do not go by the clock.
TeStatus TeViewSession::startQuality() {
  if (m_options.fps == 0 || m_common.dt > 0 || !m_nodes->any())
    return {};
  const double finest = m_options.pixelError.value_or(TeQuality::kFinest);
  if (const TeStatus ok =
          m_quality.setRange(std::min(finest, TeQuality::kMostPixels),
                             std::clamp(finest, TeQuality::kCoarsest, TeQuality::kMostPixels));
      !ok)
    return ok;
  if (const TeStatus ok = m_quality.setGoal(kDrawingShare / m_options.fps); !ok)
    return ok;
  m_nodes->setPixelError(m_quality.pixelError());
  return {};
}

void TeViewSession::steerQuality(double finishSeconds) {
  if (!m_quality.governs())
    return;
  m_quality.frameDrawn(finishSeconds);
  if (m_quality.pixelError() != m_nodes->pixelError())
    m_nodes->setPixelError(m_quality.pixelError());
}

void TeViewSession::drawn(double seconds, double finishSeconds) {
  steerQuality(finishSeconds);
  if (!m_common.report.empty()) // the log grows with every frame
    m_log.add(seconds, m_nodes->statistics());
  if (m_common.dt == 0)
    m_frameSeconds = seconds;
}

void TeViewSession::savePicture(const TeResult<TePicture>& picture) const {
  teSaveScreenshot(picture, m_options.screenshots, "terrane-view");
}

void TeViewSession::describe(TeReport& report) const {
  auto& json = report.json();
  json["shown"] = m_content.description;
  const glm::dvec3 &low = m_content.low, &high = m_content.high;
  json["box_m"] = {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
  m_flight->describe(json);
  if (m_nodes->any())
    json["settings"] = {{"pixel_error", m_nodes->pixelError()},
                        {"geomorph", m_nodes->geomorph()},
                        {"second_camera", m_controls->secondCamera()},
                        {"wireframe", m_controls->wireframe()}};
  if (m_nodes->anySeamless())
    json["settings"].update({{"precision", m_nodes->precision()},
                             {"instancing", m_nodes->instancing()},
                             {"colouring", m_nodes->colouring()}});
  for (const TeNodePtr<SoTeLodTerrain>& node : m_nodes->lodTerrains())
    json["settings"]["methods"].push_back(node->method.getValue().getString());
  m_log.describe(m_nodes->any(), m_nodes->anySeamless(), json);
}
