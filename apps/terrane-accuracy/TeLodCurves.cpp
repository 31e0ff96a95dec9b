#include "apps/terrane-accuracy/TeLodCurves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace {

constexpr double kBeyond = 1.25; ///< an error may lie outside of the measured ones by this factor

std::string textAt(const TeTable& table, std::size_t row, const std::string& column) {
  const auto* text = std::get_if<std::string>(&table.cell(row, column));
  return text ? *text : std::string();
}

} // namespace

TeLodCurve::TeLodCurve(const TeTable& table, std::string name, std::vector<std::size_t> rows)
    : m_table(&table), m_name(std::move(name)), m_rows(std::move(rows)) {
  const auto errorOf = [&](std::size_t row) {
    const double error = table.number(row, "worst_px");
    return std::isfinite(error) && error > 0 ? error : 0;
  };
  std::stable_sort(m_rows.begin(), m_rows.end(),
                   [&](std::size_t a, std::size_t b) { return errorOf(a) < errorOf(b); });
  for (const std::size_t row : m_rows)
    if (errorOf(row) > 0)
      m_errors.push_back(errorOf(row));
}

std::optional<double> TeLodCurve::at(const std::string& column, double error) const {
  const std::size_t unusable = m_rows.size() - m_errors.size();
  const auto valueAt = [&](std::size_t point) { return m_table->number(m_rows[unusable + point], column); };
  if (isExact()) {
    const double value = m_rows.empty() ? std::nan("") : m_table->number(m_rows.front(), column);
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
  }
  if (error * kBeyond < m_errors.front() || error > m_errors.back() * kBeyond)
    return std::nullopt;
  std::size_t above =
      std::size_t(std::upper_bound(m_errors.begin(), m_errors.end(), error) - m_errors.begin());
  above = std::clamp<std::size_t>(above, std::min<std::size_t>(1, m_errors.size() - 1), m_errors.size() - 1);
  const std::size_t below = above > 0 ? above - 1 : 0;
  const double low = valueAt(below), high = valueAt(above);
  if (!(low > 0) || !(high > 0) || !std::isfinite(low + high))
    return std::nullopt;
  const double span = std::log(m_errors[above] / m_errors[below]);
  const double share = span > 0 ? std::log(error / m_errors[below]) / span : 0;
  return std::exp(std::log(low) + share * std::log(high / low));
}

std::vector<TeLodCurve> teLodCurves(const TeTable& table) {
  using Key = std::pair<std::string, std::string>;
  std::vector<Key> order;
  std::map<Key, std::vector<std::size_t>> rows;
  std::map<std::string, std::set<std::string>> layouts;
  for (std::size_t row = 0; row < table.rows(); row++) {
    const Key key(textAt(table, row, "method"), textAt(table, row, "layout"));
    if (rows[key].empty())
      order.push_back(key);
    rows[key].push_back(row);
    layouts[key.first].insert(key.second);
  }
  std::vector<TeLodCurve> curves;
  for (const Key& key : order)
    curves.emplace_back(table,
                        layouts[key.first].size() > 1 && !key.second.empty() ? key.first + ' ' + key.second
                                                                             : key.first,
                        rows[key]);
  return curves;
}
