#include "apps/terrane-accuracy/TeLodTable.h"

#include "apps/terrane-accuracy/TeLodCurves.h"

TeLodTable::TeLodTable()
    : m_table({"method",         "wanted_px",    "dial",          "triangles",
               "select_ms",      "upload_bytes", "frame_ms",      "worst_px",
               "p999_px",        "rms_px",       "worst_m",       "bound_px",
               "uncovered",      "cracks",       "popping_px",    "bytes_per_sample",
               "layout",         "frames",       "overshoots",    "draw_calls",
               "parts",          "visited",      "changes",       "select_low_ms",
               "select_high_ms", "frame_low_ms", "frame_high_ms", "raw_frame_ms",
               "frame_ratio"}) {}

void TeLodTable::add(const TeLodCandidate& candidate, const TeLodAccuracy& accuracy, int frames,
                     const TeLodFigures& figures, const std::optional<TeFrameFigures>& drawn) {
  using Cell = TeTable::Cell;
  const auto ofFrames = [&](double value) { return drawn ? Cell(value) : Cell(); };
  const TeFrameFigures times = drawn.value_or(TeFrameFigures());
  std::vector<Cell> cells;
  cells.emplace_back(candidate.name());
  cells.push_back(accuracy.dial > 0 ? Cell() : Cell(accuracy.pixelError));
  for (const double value : {figures.dial, figures.triangles, figures.selectMs.median, figures.uploadBytes})
    cells.emplace_back(value);
  cells.push_back(ofFrames(times.ms.median));
  for (const double value : {figures.errors.worstPixels(), figures.errors.p999Pixels(),
                             figures.errors.rmsPixels(), figures.errors.worstMetres(), figures.boundPixels})
    cells.emplace_back(value);
  cells.emplace_back(figures.errors.uncovered());
  cells.emplace_back(figures.cracks);
  cells.emplace_back(figures.errors.popping());
  cells.emplace_back(candidate.method().bytesPerSample());
  cells.emplace_back(candidate.layout());
  cells.emplace_back(std::int64_t(frames));
  cells.emplace_back(figures.overshoots);
  for (const double value : {figures.drawCalls, figures.parts, figures.visited, figures.changes,
                             figures.selectMs.low, figures.selectMs.high})
    cells.emplace_back(value);
  for (const double value : {times.ms.low, times.ms.high, times.rawMs.median, times.ratio.median})
    cells.push_back(ofFrames(value));
  m_table.addRow(std::move(cells));
}

TePlot TeLodTable::plot(const std::string& title, const std::string& column, const std::string& label) const {
  TePlot plot{title, label, "largest true error in view, pixels", true, true, {}, true, {}};
  for (const TeLodCurve& curve : teLodCurves(m_table)) {
    if (curve.isExact()) {
      plot.lines.push_back({curve.name() + ", no error", m_table.number(curve.rows().front(), column)});
      continue;
    }
    plot.curves.push_back({curve.name(), {}, {}});
    for (const std::size_t row : curve.rows()) {
      plot.curves.back().x.push_back(m_table.number(row, column));
      plot.curves.back().y.push_back(m_table.number(row, "worst_px"));
    }
  }
  return plot;
}
