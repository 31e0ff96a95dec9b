#pragma once

#include "apps/terrane-accuracy/TeTable.h"

#include <optional>
#include <string>
#include <vector>

/// The rows of one method, with one layout, in the order of their true errors: what costs how much at which
/// error.
class TeLodCurve {
public:
  /// `name`: of the method, with its layout where the table has several.
  TeLodCurve(const TeTable& table, std::string name, std::vector<std::size_t> rows);

  const std::string& name() const { return m_name; }
  const std::vector<std::size_t>& rows() const { return m_rows; }
  /// It has no error at any accuracy: its costs are those of drawing everything.
  bool isExact() const { return m_errors.empty(); }

  /// Of a column at a true error in pixels: between the measured ones, or a quarter beyond, by lines on
  /// logarithmic scales. Empty further out, and where nothing was measured.
  std::optional<double> at(const std::string& column, double error) const;

private:
  const TeTable* m_table;
  std::string m_name;
  std::vector<std::size_t> m_rows;
  std::vector<double> m_errors; ///< pixels, ascending; of the last of m_rows that have one
};

/// All curves of a table of `terrane-accuracy lod`, in its order. The table must outlive them.
std::vector<TeLodCurve> teLodCurves(const TeTable& table);
