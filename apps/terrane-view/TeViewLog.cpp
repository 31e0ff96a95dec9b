#include "apps/terrane-view/TeViewLog.h"

#include <algorithm>
#include <cmath>

namespace {

using Json = nlohmann::ordered_json;

/// Infinite values, which JSON has no word for, become null.
Json numberOf(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json spread(std::vector<double> values) {
  if (values.empty())
    return {};
  double sum = 0;
  for (const double value : values)
    sum += value;
  std::sort(values.begin(), values.end());
  return {{"median", numberOf(values[values.size() / 2])},
          {"mean", numberOf(sum / double(values.size()))},
          {"worst", numberOf(values.back())}};
}

} // namespace

void TeViewLog::add(double seconds, const TeSeamlessStatistics& figures) {
  m_frames.push_back({seconds, figures});
}

double TeViewLog::meanSeconds() const {
  double sum = 0;
  for (const Frame& frame : m_frames)
    sum += frame.seconds;
  return m_frames.empty() ? 0 : sum / double(m_frames.size());
}

double TeViewLog::longestSeconds() const {
  double longest = 0;
  for (const Frame& frame : m_frames)
    longest = std::max(longest, frame.seconds);
  return longest;
}

void TeViewLog::describe(bool shapes, bool seamless, Json& report) const {
  const auto over = [&](const auto& value) {
    std::vector<double> values;
    for (const Frame& frame : m_frames)
      values.push_back(double(value(frame)));
    return spread(std::move(values));
  };
  report["frame_ms"] = over([](const Frame& frame) { return 1000 * frame.seconds; });
  if (!shapes)
    return;
  report["selection_ms"] = over([](const Frame& frame) { return 1000 * frame.figures.selectionSeconds; });
  report["triangles"] = over([](const Frame& frame) { return frame.figures.faces; });
  report["draw_calls"] = over([](const Frame& frame) { return frame.figures.drawCalls; });
  report["patches_traversed"] = over([](const Frame& frame) { return frame.figures.traversed; });
  report["patches_culled"] = over([](const Frame& frame) { return frame.figures.culled; });
  report["patches_rendered"] = over([](const Frame& frame) { return frame.figures.rendered; });
  report["bytes_uploaded"] = over([](const Frame& frame) { return frame.figures.bytesUploaded; });
  report["error_bound_px"] = over([](const Frame& frame) { return frame.figures.errorBound; });
  if (seamless)
    report["equivalent_precision"] = over([](const Frame& frame) { return frame.figures.precision; });
  std::int64_t bytes = 0;
  for (const Frame& frame : m_frames)
    bytes += frame.figures.bytesUploaded;
  report["bytes_uploaded_in_all"] = bytes;
}
