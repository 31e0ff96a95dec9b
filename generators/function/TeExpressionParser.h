#pragma once

#include "generators/function/TeExpression.h"

#include <string>
#include <string_view>

/// Recursive descent over an expression's text, writing the program of a TeExpression.
class TeExpressionParser {
public:
  explicit TeExpressionParser(std::string_view text) : m_text(text) {}
  TeResult<TeExpression> parse();

private:
  using Code = TeExpression::Code;
  // Each reads one construct; false = m_error is set.
  bool readSum();
  bool readProduct();
  bool readSigned();
  bool readPower();
  bool readOperand();
  bool readNumber();
  bool readName();
  bool readArguments(std::string_view function, int count);

  void skipBlanks();
  /// Skips blanks; true and behind the character if it is the next one.
  bool accept(char c);
  void emit(Code code, double number = 0);
  bool fail(std::string reason);

  std::string_view m_text;
  std::size_t m_at = 0;
  int m_depth = 0; ///< of nested constructs
  TeExpression m_result;
  TeError m_error;
};
