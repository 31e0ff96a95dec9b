#include "generators/function/TeFunctionGenerator.h"

#include "generators/base/TeHash.h"
#include "generators/function/TeFunctionSource.h"

TeFunctionGenerator::TeFunctionGenerator() { setDefaults(); }

void TeFunctionGenerator::setDefaults() {
  z = "30*sin(x/70)*cos(y/90)";
  function = nullptr;
  functionName.clear();
}

TeParameters TeFunctionGenerator::parameters() {
  return {{"z", &z, 0, 0, {}, "height in metres as an expression in x and y (metres)"}};
}

TeResult<TeHeightSourcePtr> TeFunctionGenerator::makeSource() const {
  if (function) {
    if (functionName.empty())
      return TeError{"function: a function of the program's own needs a functionName"};
    const std::uint64_t fingerprint =
        teHashCombine(teHashText("function of a program"), teHashText(functionName));
    return TeHeightSourcePtr(std::make_shared<TeFunctionSource>(function, fingerprint));
  }
  TeResult<TeExpression> expression = TeExpression::compile(z);
  if (!expression)
    return TeError{"function: z: " + expression.error().message};
  const std::uint64_t fingerprint = teHashCombine(teHashText("function"), teHashText(z));
  return TeHeightSourcePtr(std::make_shared<TeFunctionSource>(std::move(*expression), fingerprint));
}
