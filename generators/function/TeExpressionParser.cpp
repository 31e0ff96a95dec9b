#include "generators/function/TeExpressionParser.h"

#include "generators/base/TeText.h"

#include <charconv>

TeResult<TeExpression> TeExpressionParser::parse() {
  if (m_text.size() > TeExpression::kLongest) {
    m_at = TeExpression::kLongest;
    fail("longer than " + std::to_string(TeExpression::kLongest) + " characters");
    return m_error;
  }
  if (!readSum())
    return m_error;
  skipBlanks();
  if (m_at < m_text.size()) {
    fail("expected an operator or the end, found " + teQuoted(m_text.substr(m_at, 1)));
    return m_error;
  }
  return std::move(m_result);
}

bool TeExpressionParser::readSum() {
  if (!readProduct())
    return false;
  for (;;) {
    const bool plus = accept('+');
    if (!plus && !accept('-'))
      return true;
    if (!readProduct())
      return false;
    emit(plus ? Code::Add : Code::Subtract);
  }
}

bool TeExpressionParser::readProduct() {
  if (!readSigned())
    return false;
  for (;;) {
    const bool times = accept('*');
    if (!times && !accept('/'))
      return true;
    if (!readSigned())
      return false;
    emit(times ? Code::Multiply : Code::Divide);
  }
}

// Every recursion passes here, so this is where the depth is bounded.
bool TeExpressionParser::readSigned() {
  if (m_depth == TeExpression::kDeepest)
    return fail("nested deeper than " + std::to_string(TeExpression::kDeepest));
  ++m_depth;
  bool ok;
  if (accept('-')) {
    ok = readSigned();
    emit(Code::Negate);
  } else {
    ok = readPower();
  }
  --m_depth;
  return ok;
}

bool TeExpressionParser::readPower() {
  if (!readOperand())
    return false;
  if (!accept('^'))
    return true;
  if (!readSigned())
    return false;
  emit(Code::Power);
  return true;
}

bool TeExpressionParser::readOperand() {
  if (accept('(')) {
    if (!readSum())
      return false;
    return accept(')') || fail("expected ')'");
  }
  if (m_at == m_text.size())
    return fail("expected a number, a name or '(', found the end");
  const char c = m_text[m_at];
  if ((c >= '0' && c <= '9') || c == '.')
    return readNumber();
  if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))
    return readName();
  return fail("expected a number, a name or '(', found " + teQuoted(m_text.substr(m_at, 1)));
}

bool TeExpressionParser::readNumber() {
  double number = 0;
  const char* end = m_text.data() + m_text.size();
  const std::from_chars_result result = std::from_chars(m_text.data() + m_at, end, number);
  if (result.ec != std::errc())
    return fail("not a number that a double can hold");
  m_at = std::size_t(result.ptr - m_text.data());
  emit(Code::Number, number);
  return true;
}

bool TeExpressionParser::readName() {
  struct Function {
    const char* name;
    Code code;
    int arguments;
  };
  static constexpr Function kFunctions[] = {
      {"sqrt", Code::Sqrt, 1}, {"abs", Code::Abs, 1}, {"floor", Code::Floor, 1}, {"sin", Code::Sin, 1},
      {"cos", Code::Cos, 1},   {"exp", Code::Exp, 1}, {"log", Code::Log, 1},     {"tanh", Code::Tanh, 1},
      {"min", Code::Min, 2},   {"max", Code::Max, 2}};
  const std::size_t begin = m_at;
  const auto inName = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  while (m_at < m_text.size() && inName(m_text[m_at]))
    ++m_at;
  const std::string_view name = m_text.substr(begin, m_at - begin);
  if (name == "x" || name == "y") {
    emit(name == "x" ? Code::X : Code::Y);
    return true;
  }
  if (name == "pi") {
    emit(Code::Number, 0x1.921fb54442d18p+1);
    return true;
  }
  std::vector<std::string> known = {"x", "y", "pi"};
  for (const Function& function : kFunctions) {
    if (name == function.name) {
      if (!readArguments(name, function.arguments))
        return false;
      emit(function.code);
      return true;
    }
    known.push_back(function.name);
  }
  m_at = begin;
  return fail("unknown name " + teQuoted(name) + teKnownNames(name, known));
}

bool TeExpressionParser::readArguments(std::string_view function, int count) {
  if (!accept('('))
    return fail("expected '(' after " + std::string(function));
  for (int i = 0; i < count; ++i) {
    if (i > 0 && !accept(','))
      return fail(std::string(function) + " takes " + std::to_string(count) + " arguments: expected ','");
    if (!readSum())
      return false;
  }
  return accept(')') || fail(std::string(function) + " takes " + std::to_string(count) +
                             (count == 1 ? " argument" : " arguments") + ": expected ')'");
}

void TeExpressionParser::skipBlanks() {
  while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t'))
    ++m_at;
}

bool TeExpressionParser::accept(char c) {
  skipBlanks();
  if (m_at == m_text.size() || m_text[m_at] != c)
    return false;
  ++m_at;
  return true;
}

void TeExpressionParser::emit(Code code, double number) { m_result.m_program.push_back({code, number}); }

bool TeExpressionParser::fail(std::string reason) {
  m_error.message = "expression " + teQuoted(m_text) + ", column " + std::to_string(m_at + 1) + ": " + reason;
  return false;
}
