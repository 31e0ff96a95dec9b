#pragma once

#include "apps/common/TeCommandLine.h"
#include "apps/common/TeEngineApp.h"
#include "apps/terrane-drive/TeWheelCheck.h"
#include "nodes/TeSurfaceColours.h"

/// What terrane-drive adds to a run: a car, and figures about its wheels.
class TeDriveApp final : public TeEngineApp {
public:
  /// Adds --auto to a command line, which reads it into this object when it is parsed.
  void addTo(TeCommandLine& commandLine);
  /// In place of those that the engine finds for a world.
  void setColours(const TeSurfaceColours& colours) { m_colours = colours; }

  TeStatus setUp(TeEngine& engine, SoSeparator& scene, glm::dvec2 start) override;
  void afterTick() override;
  void describe(nlohmann::ordered_json& report) const override;
  Settings settings() const override;

private:
  bool m_auto = false;
  std::optional<TeSurfaceColours> m_colours;
  TeEngine* m_engine = nullptr;
  TeCar* m_car = nullptr; ///< the engine's
  TeWheelCheck m_wheels;
};
