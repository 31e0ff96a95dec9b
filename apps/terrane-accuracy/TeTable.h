#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// A table of figures: written as CSV, JSON and Markdown. A number that was not measured is an empty cell.
class TeTable {
public:
  using Cell = std::variant<std::monostate, std::string, std::int64_t, double>;

  explicit TeTable(std::vector<std::string> columns) : m_columns(std::move(columns)) {}

  /// One cell a column.
  void addRow(std::vector<Cell> cells);

  const std::vector<std::string>& columns() const { return m_columns; }
  std::size_t rows() const { return m_rows.size(); }
  const Cell& cell(std::size_t row, const std::string& column) const;
  /// NaN where there is no number.
  double number(std::size_t row, const std::string& column) const;

  /// The first line has the columns' names; numbers to six digits; texts with commas or quotes are quoted.
  std::string csv() const;
  /// An array of objects; infinite numbers become null, as JSON has none.
  nlohmann::ordered_json json() const;
  std::string markdown() const;

private:
  std::vector<std::string> m_columns;
  std::vector<std::vector<Cell>> m_rows;
};
