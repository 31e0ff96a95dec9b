#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>
#include <string_view>
#include <vector>

/// An arithmetic expression in x and y, compiled for fast evaluation over many points.
///
/// Operators by rising precedence: + -, * /, unary -, ^ (power, right to left: -2^2 is -4). Names: x, y, pi.
/// Functions: sqrt abs floor sin cos exp log tanh of one argument, min max of two. Numbers as in C++; blanks
/// are ignored. All in double, from left to right, with the functions of TeMath.h, so the bits are the same
/// everywhere. Outside a function's domain, and from 0/0, comes NaN.
///
/// Text of up to kLongest characters, nested up to kDeepest; evaluation uses a fixed amount of stack. Const
/// members are thread-safe. Cost: about 1 ns an arithmetic operation, 10 to 20 ns a function.
class TeExpression {
public:
  static constexpr std::size_t kLongest = 4096;
  static constexpr int kDeepest = 32;

  /// Error: the first fault, with its column.
  static TeResult<TeExpression> compile(std::string_view text);

  /// z[i] = value at (x[i], y[i]).
  void evaluate(const double* x, const double* y, int count, double* z) const;
  double operator()(double x, double y) const;

private:
  friend class TeExpressionParser;
  enum class Code : std::uint8_t {
    Number,
    X,
    Y,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negate,
    Sqrt,
    Abs,
    Floor,
    Sin,
    Cos,
    Exp,
    Log,
    Tanh,
    Min,
    Max
  };
  struct Instruction {
    Code code;
    double number; ///< of Number
  };
  void evaluateBlock(const double* x, const double* y, int count, double* z) const;

  std::vector<Instruction> m_program; ///< for a stack machine
};
