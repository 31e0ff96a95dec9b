#pragma once

#include "generators/TeGenerator.h"

#include <cstdint>
#include <functional>
#include <string>

/// Terrain given by a mathematical function z = f(x, y) of world coordinates in metres (document 000).
///
/// Depends on the place alone, so maps fit without blending, and can be evaluated at scattered points. A
/// value that is not finite, also as a float, is a missing sample. Cost: the function's.
class TeFunctionGenerator final : public TeGenerator {
public:
  TeFunctionGenerator();
  std::string name() const override { return "function"; }
  TeParameters parameters() override;

  /// The function as an expression in x and y; see TeExpression.
  std::string z;

  /// A program's own function, used in place of z if it is set: pure, thread-safe and without exceptions.
  std::function<double(double x, double y)> function;
  /// Tells one function from another in fingerprints: equal names stand for equal functions. Must not be
  /// empty if `function` is set.
  std::string functionName;

protected:
  void setDefaults() override;
  TeResult<TeHeightSourcePtr> makeSource() const override;
};
