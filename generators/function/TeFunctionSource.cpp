#include "generators/function/TeFunctionSource.h"

#include "generators/base/TeFloatEnvironment.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr int kBlock = 64;
}

TeStatus TeFunctionSource::evaluate(const TeMapRequest& request, const TeMapSample* samples,
                                    std::size_t count, float* heights) const {
  const TeFloatEnvironment environment;
  double x[kBlock];
  double y[kBlock];
  for (std::size_t first = 0; first < count; first += kBlock) {
    const int n = int(std::min<std::size_t>(kBlock, count - first));
    for (int i = 0; i < n; ++i) {
      x[i] = request.x(samples[first + std::size_t(i)].column);
      y[i] = request.y(samples[first + std::size_t(i)].row);
    }
    evaluateBlock(x, y, n, heights + first);
  }
  return {};
}

void TeFunctionSource::evaluateBlock(const double* x, const double* y, int count, float* heights) const {
  double z[kBlock];
  if (const TeExpression* expression = std::get_if<TeExpression>(&m_function)) {
    expression->evaluate(x, y, count, z);
  } else {
    const Function& function = std::get<Function>(m_function);
    for (int i = 0; i < count; ++i)
      z[i] = function(x[i], y[i]);
  }
  for (int i = 0; i < count; ++i) {
    const float height = float(z[i]);
    heights[i] = std::isfinite(height) ? height : TeHeightMap::missing();
  }
}
