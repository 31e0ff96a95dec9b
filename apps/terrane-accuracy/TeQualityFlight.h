#pragma once

#include "apps/common/TeCommonOptions.h"
#include "apps/common/TeEngineStage.h"
#include "apps/terrane-accuracy/TeQualityTrace.h"
#include "nodes/TeSceneRenderer.h"

#include <functional>
#include <memory>

/// A real flight over endless terrain, drawn by the engine with a quality goal. The load is how often each
/// frame's scene is drawn, as for more than one eye or screen: twice is exactly twice the cost, whatever the
/// detail.
///
/// Where OpenGL is drawn by the CPU, a frame's seconds are CPU time of all threads, so that other programs on
/// the machine do not disturb; else of the wall clock. Either way time goes on by what ticks and frames take.
class TeQualityFlight {
public:
  /// Called before each frame with the seconds of the flight so far.
  using Progress = std::function<void(double seconds)>;

  /// Error: no such context here, terrain that cannot be made.
  static TeResult<std::unique_ptr<TeQualityFlight>> create(const TeCommonOptions& common, int radius);
  ~TeQualityFlight();

  /// A goal that can be held under loads 1 and `load`: between what the coarsest picture costs then and what
  /// the finest costs now, frames a second. Error: there is none, for detail makes too little difference.
  TeResult<double> findRate(double load);
  /// Flies under the steps' loads.
  TeResult<TeQualityTrace> run(double rate, const std::vector<TeQualityTrace::Step>& steps,
                               const Progress& progress);
  /// False: of the wall clock.
  bool byCpu() const { return m_byCpu; }
  std::string renderer() const { return m_context->renderer(); }
  const std::string& terrain() const { return m_stage->terrain(); }

private:
  TeQualityFlight() = default;
  /// Seconds of this process, see above.
  double seconds() const;
  /// Seconds until OpenGL was done.
  TeResult<double> draw();
  TeResult<double> costAt(double pixels);
  void setLoad(double load);

  bool m_byCpu = false;
  std::unique_ptr<TeContext> m_context;
  std::unique_ptr<TeEngineStage> m_stage;
  std::unique_ptr<TeSceneRenderer> m_renderer;
  TeNodePtr<SoSeparator> m_root; ///< the stage's scene, once or several times
};
