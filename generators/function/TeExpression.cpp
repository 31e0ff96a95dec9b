#include "generators/function/TeExpression.h"

#include "generators/base/TeMath.h"
#include "generators/function/TeExpressionParser.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr int kBlock = 64;
/// Each level of nesting can leave a sum, a product and a first argument (or a power) unfinished.
constexpr int kStack = 3 * TeExpression::kDeepest + 1;

/// The smaller one; NaN if either is.
double lesser(double a, double b) { return a < b || a != a ? a : b; }
double greater(double a, double b) { return a > b || a != a ? a : b; }

template <class Operation> void unary(double* a, int count, Operation operation) {
  for (int i = 0; i < count; ++i)
    a[i] = operation(a[i]);
}

template <class Operation> void binary(double* a, const double* b, int count, Operation operation) {
  for (int i = 0; i < count; ++i)
    a[i] = operation(a[i], b[i]);
}

} // namespace

TeResult<TeExpression> TeExpression::compile(std::string_view text) {
  return TeExpressionParser(text).parse();
}

void TeExpression::evaluate(const double* x, const double* y, int count, double* z) const {
  for (int first = 0; first < count; first += kBlock)
    evaluateBlock(x + first, y + first, std::min(kBlock, count - first), z + first);
}

double TeExpression::operator()(double x, double y) const {
  double z;
  evaluate(&x, &y, 1, &z);
  return z;
}

void TeExpression::evaluateBlock(const double* x, const double* y, int n, double* z) const {
  double stack[kStack][kBlock];
  int height = 0;
  for (const Instruction& instruction : m_program) {
    double* top = stack[height > 0 ? height - 1 : 0];
    double* below = stack[height > 1 ? height - 2 : 0];
    const Code code = instruction.code;
    if (code == Code::Number || code == Code::X || code == Code::Y)
      assert(height < kStack);
    switch (code) {
    case Code::Number:
      std::fill_n(stack[height++], n, instruction.number);
      break;
    case Code::X:
      std::copy_n(x, n, stack[height++]);
      break;
    case Code::Y:
      std::copy_n(y, n, stack[height++]);
      break;
    case Code::Negate:
      unary(top, n, [](double a) { return -a; });
      break;
    case Code::Sqrt:
      unary(top, n, [](double a) { return std::sqrt(a); });
      break;
    case Code::Abs:
      unary(top, n, [](double a) { return std::fabs(a); });
      break;
    case Code::Floor:
      unary(top, n, [](double a) { return std::floor(a); });
      break;
    case Code::Sin:
      unary(top, n, teSin);
      break;
    case Code::Cos:
      unary(top, n, teCos);
      break;
    case Code::Exp:
      unary(top, n, teExp);
      break;
    case Code::Log:
      unary(top, n, teLog);
      break;
    case Code::Tanh:
      unary(top, n, teTanh);
      break;
    case Code::Add:
      binary(below, top, n, [](double a, double b) { return a + b; });
      --height;
      break;
    case Code::Subtract:
      binary(below, top, n, [](double a, double b) { return a - b; });
      --height;
      break;
    case Code::Multiply:
      binary(below, top, n, [](double a, double b) { return a * b; });
      --height;
      break;
    case Code::Divide:
      binary(below, top, n, [](double a, double b) { return a / b; });
      --height;
      break;
    case Code::Power:
      binary(below, top, n, tePow);
      --height;
      break;
    case Code::Min:
      binary(below, top, n, lesser);
      --height;
      break;
    case Code::Max:
      binary(below, top, n, greater);
      --height;
      break;
    }
  }
  std::copy_n(stack[0], n, z);
}
