#include "apps/terrane-accuracy/TeLodVerdict.h"

#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace {

/// Times that differ by less are alike, as far as times can be measured.
constexpr double kAlike = 1.1;

/// Two digits that count, without powers of ten.
std::string amount(double value) {
  if (value >= 1000) {
    std::string digits = teFormat("%.0f", value);
    for (int place = int(digits.size()) - 3; place > 0; place -= 3)
      digits.insert(std::size_t(place), ",");
    return digits;
  }
  return teFormat(value >= 99.5 ? "%.0f" : value >= 9.95 ? "%.1f" : "%.2g", value);
}

std::string times(double factor) {
  return (factor > 0.95 && factor < 1.05 ? teFormat("%.2f", factor) : amount(factor)) + " times";
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); i++)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

} // namespace

TeLodVerdict::TeLodVerdict(const TeTable& table) : m_table(&table), m_curves(teLodCurves(table)) {
  for (std::size_t row = 0; row < table.rows(); row++) {
    const double wanted = table.number(row, "wanted_px");
    if (wanted > 0 && std::find(m_errors.begin(), m_errors.end(), wanted) == m_errors.end() &&
        ranking("triangles", wanted).size() >= 2)
      m_errors.push_back(wanted);
  }
  std::sort(m_errors.begin(), m_errors.end());
}

std::vector<TeLodVerdict::Cost> TeLodVerdict::ranking(const std::string& column, double error) const {
  std::vector<Cost> costs;
  for (const TeLodCurve& curve : m_curves)
    if (!curve.isExact())
      if (const std::optional<double> value = curve.at(column, error))
        costs.push_back({&curve, *value});
  std::stable_sort(costs.begin(), costs.end(),
                   [](const Cost& a, const Cost& b) { return a.value < b.value; });
  return costs;
}

std::string TeLodVerdict::rankingText(const std::vector<Cost>& ranking) const {
  std::vector<std::string> parts;
  for (std::size_t i = 1; i < ranking.size(); i++)
    parts.push_back(ranking[i].curve->name() + " " + times(ranking[i].value / ranking[0].value));
  return joined(parts);
}

std::vector<std::string> TeLodVerdict::paragraphs() const {
  std::vector<std::string> all = {promises()};
  if (m_errors.size() >= 2)
    all.push_back("Costs at the same true error, interpolated between what was measured. How many times the "
                  "triangles of the best each method needs:");
  all.push_back(ratios());
  std::vector<double> told; // the least error, one in the middle, the largest
  for (const std::size_t place : {std::size_t(0), m_errors.size() / 2, m_errors.size() - 1})
    if (place < m_errors.size() && (told.empty() || told.back() < m_errors[place]))
      told.push_back(m_errors[place]);
  for (const double error : told)
    all.push_back(best(error));
  all.push_back(tenfold());
  all.push_back(memory());
  all.erase(std::remove(all.begin(), all.end(), std::string()), all.end());
  return all;
}

std::string TeLodVerdict::promises() const {
  std::vector<std::string> broken;
  double closest = 0;
  std::map<std::string, double> unbounded; ///< largest true error of the wanted one
  for (std::size_t row = 0; row < m_table->rows(); row++) {
    const double wanted = m_table->number(row, "wanted_px");
    const double share = wanted > 0 ? m_table->number(row, "worst_px") / wanted : 0;
    if (std::isinf(m_table->number(row, "bound_px"))) {
      double& most = unbounded[std::get<std::string>(m_table->cell(row, "method"))];
      most = std::max(most, share);
    } else {
      closest = std::max(closest, share);
    }
    const double over = m_table->number(row, "overshoots"), holes = m_table->number(row, "uncovered"),
                 cracks = m_table->number(row, "cracks");
    if (over + holes + cracks == 0)
      continue;
    std::string at = std::get<std::string>(m_table->cell(row, "method"));
    at += wanted > 0 ? teFormat(" at %g px", wanted) : teFormat(" at dial %g", m_table->number(row, "dial"));
    broken.push_back(at + teFormat(" (%.0f frames above the bound, %.0f samples uncovered, %.0f cracks)",
                                   over, holes, cracks));
  }
  std::string text = broken.empty()
                         ? "**What is promised holds**: no frame of any method is off by more than its "
                           "bound, no sample in view is uncovered, no edge is open."
                         : "**Promises broken**: " + joined(broken) + ".";
  if (closest > 0)
    text += teFormat(" The largest true error is %.3g of the wanted one.", closest);
  for (const auto& [method, most] : unbounded)
    text += " " + method + teFormat(" promises nothing; its errors are up to %.3g of the wanted one.", most);
  return text;
}

std::string TeLodVerdict::ratios() const {
  if (m_errors.empty())
    return {};
  std::vector<const TeLodCurve*> columns;
  std::string head = "| true error, px | fewest triangles |", line = "|---|---|";
  for (const TeLodCurve& curve : m_curves) {
    columns.push_back(&curve);
    head += " " + curve.name() + " |";
    line += "---|";
  }
  std::string text = head + "\n" + line;
  for (const double error : m_errors) {
    const std::vector<Cost> order = ranking("triangles", error);
    text += teFormat("\n| %g | ", error) + amount(order[0].value) + " |";
    for (const TeLodCurve* curve : columns) {
      const std::optional<double> value = curve->at("triangles", error);
      text += value ? " " + teFormat("%.2f", *value / order[0].value) + " |" : std::string(" |");
    }
  }
  return text;
}

std::string TeLodVerdict::best(double error) const {
  const std::vector<Cost> triangles = ranking("triangles", error), select = ranking("select_ms", error),
                          frame = ranking("frame_ms", error);
  if (triangles.size() < 2)
    return {};
  std::string text = teFormat("**At %g px** ", error) + triangles[0].curve->name() +
                     " needs the fewest triangles, " + amount(triangles[0].value) + "; " +
                     rankingText(triangles) + " as many.";
  if (select.size() >= 2)
    text += " Selection is quickest by " + select[0].curve->name() + ", " + amount(select[0].value) +
            " ms of CPU time; " + rankingText(select) + " as long.";
  if (frame.size() >= 2) {
    std::vector<std::string> alike;
    for (std::size_t i = 1; i < frame.size(); i++)
      if (frame[i].value < kAlike * frame[0].value)
        alike.push_back(frame[i].curve->name());
    text += " Frames are shortest by " + frame[0].curve->name() + ", " + amount(frame[0].value) + " ms";
    text += alike.empty() ? "" : " (" + joined(alike) + ": alike, less than a tenth more)";
    text += whyFastest(*frame[0].curve, *triangles[0].curve, error) + "; " + rankingText(frame) + " as long.";
  }
  for (const TeLodCurve& curve : m_curves) {
    if (!curve.isExact())
      continue;
    const std::optional<double> all = curve.at("triangles", error), allMs = curve.at("frame_ms", error);
    if (all)
      text += " Drawing everything (" + curve.name() + ") takes " + times(*all / triangles[0].value) +
              " the triangles" +
              (allMs && !frame.empty() ? " and " + times(*allMs / frame[0].value) + " the frame time" : "") +
              " of the best.";
  }
  return text;
}

std::string TeLodVerdict::whyFastest(const TeLodCurve& fastest, const TeLodCurve& fewest,
                                     double error) const {
  if (&fastest == &fewest)
    return ", as it has the fewest triangles";
  const auto ratio = [&](const std::string& column) {
    const std::optional<double> mine = fastest.at(column, error), other = fewest.at(column, error);
    return mine && other ? *other / *mine : 1;
  };
  const auto less = [&](const std::string& column) {
    return fewest.at(column, error).value_or(0) - fastest.at(column, error).value_or(0);
  };
  const std::string although =
      ", although it has " + times(1 / ratio("triangles")) + " the triangles of " + fewest.name() + ": ";
  // What of the difference is selection decides; then what is sent; else the drawing itself.
  if (less("select_ms") > 0.5 * less("frame_ms"))
    return although + "it selects in " + amount(*fastest.at("select_ms", error)) + " ms, not " +
           amount(*fewest.at("select_ms", error));
  if (ratio("upload_bytes") > 2)
    return although + fewest.name() + " sends " + times(ratio("upload_bytes")) + " the bytes a frame";
  if (ratio("draw_calls") > 2)
    return although + fewest.name() + " makes " + times(ratio("draw_calls")) + " the draw calls";
  const auto ns = [&](const TeLodCurve& curve) {
    return 1e6 * (curve.at("frame_ms", error).value_or(0) - curve.at("select_ms", error).value_or(0)) /
           curve.at("triangles", error).value_or(1);
  };
  return although + "a triangle of it takes " + amount(ns(fastest)) + " ns to send and draw, not " +
         amount(ns(fewest));
}

std::string TeLodVerdict::tenfold() const {
  // From ten times an error to that error, the one nearest to a pixel that most methods reach.
  double from = 0;
  std::size_t most = 0;
  for (const double error : m_errors) {
    std::size_t reached = 0;
    for (const TeLodCurve& curve : m_curves)
      reached += !curve.isExact() && curve.at("triangles", error) && curve.at("triangles", 10 * error);
    if (reached > most ||
        (reached == most && reached > 0 && std::fabs(std::log(error)) < std::fabs(std::log(from)))) {
      most = reached;
      from = error;
    }
  }
  if (most == 0)
    return {};
  std::vector<std::string> parts;
  for (const TeLodCurve& curve : m_curves) {
    if (curve.isExact())
      continue;
    const auto factor = [&](const std::string& column) -> std::optional<double> {
      const std::optional<double> fine = curve.at(column, from), coarse = curve.at(column, 10 * from);
      return fine && coarse ? std::optional<double>(*fine / *coarse) : std::nullopt;
    };
    const std::optional<double> triangles = factor("triangles"), select = factor("select_ms"),
                                frame = factor("frame_ms");
    if (triangles)
      parts.push_back(curve.name() + " " + times(*triangles) + " the triangles" +
                      (select ? ", " + times(*select) + " the selection" : "") +
                      (frame ? ", " + times(*frame) + " the frame" : ""));
  }
  std::string text = teFormat("**Ten times the accuracy**, %g px in place of %g px, costs", from, 10 * from);
  for (std::size_t i = 0; i < parts.size(); i++)
    text += (i ? "; " : " ") + parts[i];
  return text + ".";
}

std::string TeLodVerdict::memory() const {
  std::vector<Cost> costs;
  for (const TeLodCurve& curve : m_curves) {
    double bytes = 0;
    for (const std::size_t row : curve.rows())
      bytes = std::max(bytes, m_table->number(row, "bytes_per_sample"));
    costs.push_back({&curve, bytes});
  }
  std::stable_sort(costs.begin(), costs.end(),
                   [](const Cost& a, const Cost& b) { return a.value < b.value; });
  std::vector<std::string> parts;
  for (const Cost& cost : costs)
    if (cost.value > 0)
      parts.push_back(cost.curve->name() + " " + amount(cost.value));
  return parts.empty() ? std::string() : "**Memory**, bytes a sample with the sample: " + joined(parts) + ".";
}
