#include "apps/terrane-accuracy/TeLodDrawing.h"

#include "apps/terrane-accuracy/TeLayoutText.h"

TeResult<std::unique_ptr<TeLodDrawing>> TeLodDrawing::create(const TeLodCandidate& candidate,
                                                             const TeMeasuredTerrain& terrain,
                                                             TeFlightStage& stage) {
  std::unique_ptr<TeLodDrawing> drawing(new TeLodDrawing(stage));
  if (candidate.layout().empty())
    drawing->prepareOther(candidate, terrain);
  else if (const TeStatus ok = drawing->prepareSeamless(candidate, terrain); !ok)
    return ok.error();
  const std::string& error =
      drawing->m_seamless ? drawing->m_seamless->getError() : drawing->m_other->getError();
  if (!error.empty())
    return TeError{candidate.name() + ": " + error};
  return drawing;
}

void TeLodDrawing::prepareOther(const TeLodCandidate& candidate, const TeMeasuredTerrain& terrain) {
  m_other = TeNodePtr<SoTeLodTerrain>(new SoTeLodTerrain);
  m_other->method = candidate.method().name().c_str();
  m_other->geomorph = candidate.geomorph();
  m_other->maxTriangles = 1 << 28;
  m_other->setField(terrain.field);
}

TeStatus TeLodDrawing::prepareSeamless(const TeLodCandidate& candidate, const TeMeasuredTerrain& terrain) {
  TeHeightMap metres = terrain.heights();
  if (const TeStatus ok = metres.scale(float(terrain.heightScale()), metres.bounds()); !ok)
    return ok;
  int minResolution = 0, levels = 0;
  teReadLayout(candidate.layout(), minResolution, levels);
  const double side = terrain.spacing() * terrain.cells();
  m_seamless = TeNodePtr<SoTeSeamlessPatches>(new SoTeSeamlessPatches);
  m_seamless->size.setValue(float(side), float(side), 1);
  m_seamless->center.setValue(0.5 * side, 0.5 * side, 0);
  m_seamless->resolution = terrain.cells();
  m_seamless->minPatchResolution = minResolution;
  m_seamless->levels = levels;
  m_seamless->geomorph = candidate.geomorph();
  m_seamless->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
  m_seamless->stripColor.setValue(1, 1, 1);
  m_seamless->setHeights(std::make_shared<const TeHeightMap>(std::move(metres)));
  return {};
}

TeResult<double> TeLodDrawing::draw(const TeLodAccuracy& accuracy, const TePerspectiveView& view) {
  if (m_seamless) {
    m_seamless->pixelError = accuracy.dial > 0 ? 0.0f : float(accuracy.pixelError);
    m_seamless->precision = accuracy.dial > 0 ? float(accuracy.dial) : 1.0f;
    m_stage.show(m_seamless.get());
  } else {
    m_other->pixelError = float(accuracy.pixelError);
    m_other->dial = float(accuracy.dial);
    m_stage.show(m_other.get());
  }
  return m_stage.draw(view);
}
