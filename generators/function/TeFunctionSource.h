#pragma once

#include "generators/TeHeightSource.h"
#include "generators/function/TeExpression.h"

#include <functional>
#include <variant>

/// What TeFunctionGenerator makes.
class TeFunctionSource final : public TePointSource {
public:
  using Function = std::function<double(double x, double y)>;

  TeFunctionSource(std::variant<TeExpression, Function> function, std::uint64_t fingerprint)
      : m_function(std::move(function)), m_fingerprint(fingerprint) {}

  std::string name() const override { return "function"; }
  std::uint64_t fingerprint() const override { return m_fingerprint; }
  bool fits() const override { return true; }
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override;

private:
  void evaluateBlock(const double* x, const double* y, int count, float* heights) const;

  std::variant<TeExpression, Function> m_function;
  std::uint64_t m_fingerprint;
};
