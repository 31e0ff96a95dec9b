#include "apps/terrane-accuracy/TeTable.h"

#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

std::string textOf(const TeTable::Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell))
    return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&cell))
    return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&cell))
    return std::isnan(*real) ? std::string() : teFormat("%.6g", *real);
  return {};
}

std::string csvOf(const TeTable::Cell& cell) {
  const std::string text = textOf(cell);
  if (text.find_first_of(",\"\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

} // namespace

void TeTable::addRow(std::vector<Cell> cells) {
  assert(cells.size() == m_columns.size());
  m_rows.push_back(std::move(cells));
}

const TeTable::Cell& TeTable::cell(std::size_t row, const std::string& column) const {
  const auto found = std::find(m_columns.begin(), m_columns.end(), column);
  assert(found != m_columns.end());
  return m_rows[row][std::size_t(found - m_columns.begin())];
}

double TeTable::number(std::size_t row, const std::string& column) const {
  const Cell& value = cell(row, column);
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    return double(*whole);
  const auto* real = std::get_if<double>(&value);
  return real ? *real : std::numeric_limits<double>::quiet_NaN();
}

std::string TeTable::csv() const {
  std::string text;
  for (std::size_t i = 0; i < m_columns.size(); i++)
    text += (i ? "," : "") + m_columns[i];
  text += '\n';
  for (const std::vector<Cell>& row : m_rows) {
    for (std::size_t i = 0; i < row.size(); i++)
      text += (i ? "," : "") + csvOf(row[i]);
    text += '\n';
  }
  return text;
}

nlohmann::ordered_json TeTable::json() const {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const std::vector<Cell>& row : m_rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < row.size(); i++) {
      auto& value = object[m_columns[i]];
      if (const auto* text = std::get_if<std::string>(&row[i]))
        value = *text;
      else if (const auto* whole = std::get_if<std::int64_t>(&row[i]))
        value = *whole;
      else if (const auto* real = std::get_if<double>(&row[i]))
        value = *real;
    }
    rows.push_back(std::move(object));
  }
  return rows;
}

std::string TeTable::markdown() const {
  std::string text = "|";
  for (const std::string& column : m_columns)
    text += ' ' + column + " |";
  text += "\n|";
  for (std::size_t i = 0; i < m_columns.size(); i++)
    text += "---|";
  text += '\n';
  for (const std::vector<Cell>& row : m_rows) {
    text += '|';
    for (const Cell& cell : row)
      text += ' ' + textOf(cell) + " |";
    text += '\n';
  }
  return text;
}
