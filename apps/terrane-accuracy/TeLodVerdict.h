#pragma once

#include "apps/terrane-accuracy/TeLodCurves.h"

#include <string>
#include <vector>

/// What a table of `terrane-accuracy lod` says, in words: which method is best at which true error and why,
/// how many times the triangles of the best the others need there, what ten times the accuracy costs, and
/// whether what the methods promise holds. All of it is computed from the table; costs at equal errors are
/// interpolated on logarithmic scales.
class TeLodVerdict {
public:
  /// The table must outlive it. Columns as in TeLodTable.
  explicit TeLodVerdict(const TeTable& table);

  /// Paragraphs and tables of Markdown.
  std::vector<std::string> paragraphs() const;

  /// The parts.
  std::string promises() const;
  std::string ratios() const;           ///< a table; empty if methods have no error in common
  std::string best(double error) const; ///< at that error; empty if less than two methods reach it
  std::string tenfold() const;          ///< empty if no method's errors span a factor of ten
  std::string memory() const;

  /// True errors at which at least two methods can be compared: the wanted ones of the table.
  const std::vector<double>& errors() const { return m_errors; }

private:
  struct Cost {
    const TeLodCurve* curve = nullptr;
    double value = 0;
  };
  /// Of all methods but those that draw everything, the cheapest first.
  std::vector<Cost> ranking(const std::string& column, double error) const;
  std::string rankingText(const std::vector<Cost>& ranking) const;
  std::string whyFastest(const TeLodCurve& fastest, const TeLodCurve& fewest, double error) const;

  const TeTable* m_table;
  std::vector<TeLodCurve> m_curves;
  std::vector<double> m_errors;
};
