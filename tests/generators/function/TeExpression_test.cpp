#include "generators/function/TeExpression.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

double value(const char* text, double x = 0, double y = 0) {
  const auto expression = TeExpression::compile(text);
  EXPECT_TRUE(expression.ok()) << text << ": " << (expression.ok() ? "" : expression.error().message);
  return expression.ok() ? (*expression)(x, y) : std::nan("");
}

std::string errorOf(const std::string& text) {
  const auto expression = TeExpression::compile(text);
  return expression.ok() ? "" : expression.error().message;
}

} // namespace

TEST(TeExpression, OperatorsHaveTheUsualPrecedence) {
  EXPECT_EQ(value("1+2*3"), 7);
  EXPECT_EQ(value("(1+2)*3"), 9);
  EXPECT_EQ(value("10-4-3"), 3);
  EXPECT_EQ(value("100/10/5"), 2);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("--3"), 3);
  EXPECT_EQ(value(" 1 +\t2 "), 3);
  EXPECT_EQ(value("1.5e2 + .5"), 150.5);
}

TEST(TeExpression, NamesAndFunctionsAreWhatTheySay) {
  EXPECT_EQ(value("x-y", 5, 3), 2);
  EXPECT_DOUBLE_EQ(value("pi"), M_PI);
  EXPECT_EQ(value("sqrt(16)"), 4);
  EXPECT_EQ(value("abs(-3)"), 3);
  EXPECT_EQ(value("floor(-1.5)"), -2);
  EXPECT_EQ(value("min(x, y)", 5, 3), 3);
  EXPECT_EQ(value("max(x, y)", 5, 3), 5);
  EXPECT_NEAR(value("sin(x)", 1), std::sin(1), 1e-15);
  EXPECT_NEAR(value("cos(x)", 1), std::cos(1), 1e-15);
  EXPECT_NEAR(value("exp(x)", 1), std::exp(1), 1e-14);
  EXPECT_NEAR(value("log(x)", 3), std::log(3), 1e-15);
  EXPECT_NEAR(value("tanh(x)", 0.3), std::tanh(0.3), 1e-15);
  EXPECT_NEAR(value("20*sin(x/50)*cos(y/50)", 70, -30), 20 * std::sin(1.4) * std::cos(-0.6), 1e-13);
}

TEST(TeExpression, OutsideAFunctionsDomainIsNaN) {
  for (const char* text : {"sqrt(-1)", "log(-1)", "0/0", "(-2)^0.5", "min(0/0, 1)", "min(1, 0/0)",
                           "max(0/0, 1)", "max(1, 0/0)", "sin(1/0)"})
    EXPECT_TRUE(std::isnan(value(text))) << text;
}

TEST(TeExpression, ManyPointsHaveTheBitsOfSinglePoints) {
  const auto expression = TeExpression::compile("sin(x)*y + exp(-(x/100)^2) + min(x, y) - 3^(y/50)").value();
  TeRandom random(2, 2, {});
  std::vector<double> x(1000), y(1000), z(1000);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = random.uniform(-300, 300);
    y[i] = random.uniform(-300, 300);
  }
  expression.evaluate(x.data(), y.data(), 1000, z.data());
  for (std::size_t i = 0; i < x.size(); ++i)
    ASSERT_EQ(z[i], expression(x[i], y[i]));
}

TEST(TeExpression, EachFaultIsNamedWithItsColumn) {
  EXPECT_EQ(errorOf("1 +"), "expression \"1 +\", column 4: expected a number, a name or '(', found the end");
  EXPECT_EQ(errorOf("2x"), "expression \"2x\", column 2: expected an operator or the end, found \"x\"");
  EXPECT_EQ(errorOf("(1"), "expression \"(1\", column 3: expected ')'");
  EXPECT_EQ(errorOf("min(1)"), "expression \"min(1)\", column 6: min takes 2 arguments: expected ','");
  EXPECT_EQ(errorOf("sin(1,2)"), "expression \"sin(1,2)\", column 6: sin takes 1 argument: expected ')'");
  EXPECT_EQ(errorOf("sin x"), "expression \"sin x\", column 5: expected '(' after sin");
  EXPECT_NE(errorOf("sni(x)").find("column 1: unknown name \"sni\"; did you mean sin?"), std::string::npos);
  for (const char* wrong :
       {"", " ", ")", "1)", "*2", "1**2", "x y", "1e", "1..2", "sqrt()", "min(,)", "x=1", "1e999", "$"})
    EXPECT_NE(errorOf(wrong), "") << wrong;
}

TEST(TeExpression, LengthAndDepthAreBounded) {
  const auto nested = [](int depth) {
    return std::string(std::size_t(depth), '(') + "1" + std::string(std::size_t(depth), ')');
  };
  EXPECT_EQ(errorOf(nested(TeExpression::kDeepest - 1)), "");
  EXPECT_NE(errorOf(nested(TeExpression::kDeepest)).find("nested deeper than"), std::string::npos);
  EXPECT_NE(errorOf(std::string(2000, '-') + "1").find("nested deeper than"), std::string::npos);
  EXPECT_NE(errorOf(std::string(5000, '1')).find("longer than"), std::string::npos);
  std::string tower = "2";
  for (int i = 0; i < 1000; ++i)
    tower += "^1";
  EXPECT_NE(errorOf(tower), "");
  std::string sum = "1";
  for (int i = 0; i < 2000; ++i)
    sum += "+1";
  EXPECT_EQ(value(sum.c_str()), 2001);
  // The tallest stack that the depth allows: three pending operations a level.
  std::string tall;
  for (int i = 0; i < TeExpression::kDeepest - 1; ++i)
    tall += "1+2*min(3,";
  tall += "4" + std::string(std::size_t(TeExpression::kDeepest - 1), ')');
  EXPECT_EQ(value(tall.c_str()), 7);
}
