#pragma once

#include "apps/common/TeReport.h"
#include "apps/terrane-view/TeViewControls.h"
#include "apps/terrane-view/TeViewFlight.h"
#include "apps/terrane-view/TeViewLog.h"
#include "apps/terrane-view/TeViewStage.h"
#include "engine/quality/TeQuality.h"

#include <memory>

/// One run: what is shown, who flies, what keys have switched, and what is to be told in the end.
class TeViewSession {
public:
  /// Error: bad options or input. After TeNodes::init().
  static TeResult<std::unique_ptr<TeViewSession>> create(const TeViewOptions& options,
                                                         const TeCommonOptions& common);

  const TeCommonOptions& common() const { return m_common; }
  TeViewStage& stage() { return *m_stage; }
  TeViewLog& log() { return m_log; }
  TeViewFlight& flight() { return *m_flight; }
  const TeLodNodes& nodes() const { return *m_nodes; }
  /// Whether something changes by itself with time.
  bool moving() const { return m_flight->moving() && !m_controls->paused(); }

  /// Moves on by so many seconds and brings all nodes up to date.
  void advance(double dt);
  void heard(const TeKeyEvent& event);
  /// A frame was drawn: seconds to be shown, and those from the beginning of drawing until OpenGL was done.
  void drawn(double seconds, double finishSeconds);
  bool ended() const { return m_ended; }
  /// True once after F12.
  bool takePictureWanted() { return std::exchange(m_pictureWanted, false); }
  void savePicture(const TeResult<TePicture>& picture) const;

  void describe(TeReport& report) const;

private:
  TeViewSession(const TeViewOptions& options, const TeCommonOptions& common)
      : m_options(options), m_common(common) {}
  void updateText();
  TeStatus startQuality();
  void steerQuality(double finishSeconds);

  const TeViewOptions& m_options;
  const TeCommonOptions& m_common;
  TeViewContent m_content;
  std::unique_ptr<TeViewStage> m_stage;
  std::unique_ptr<TeLodNodes> m_nodes;
  std::unique_ptr<TeViewControls> m_controls;
  std::unique_ptr<TeViewFlight> m_flight;
  TeViewLog m_log;
  double m_frameSeconds = 0; ///< of the last one; stays 0 in runs that repeat
  TeQuality m_quality;       ///< has a goal only with --fps
  bool m_ended = false;
  bool m_pictureWanted = false;
};
