#include "io/case/expression.hpp"
#include "io/case/case_file.hpp"
#include "support/simulations.hpp"
#include <thread>

namespace expression_test {

std::string fault_of(const std::string& text, const std::map<std::string, Real>& constants = {})
{
  return refusal<ExpressionError>([&] { evaluate(text, constants); });
}

TEST(Expression, KnowsOperatorsFunctionsAndPi)
{
  EXPECT_DOUBLE_EQ(evaluate("2+3*4^2/8-1", {}), 7.0);
  EXPECT_DOUBLE_EQ(evaluate("sin(pi/6)", {}), 0.5);
  EXPECT_DOUBLE_EQ(evaluate("atan2(1,-1)", {}), 0.75 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(evaluate("2 > 1 && 1 > 2 ? 5 : 7", {}), 7.0);
  EXPECT_NEAR(evaluate("erf(0.5)+erfc(0.5)", {}), 1.0, 1e-15);
  EXPECT_DOUBLE_EQ(evaluate("mod(-1,3)", {}), 2.0);
  EXPECT_DOUBLE_EQ(evaluate("step(-0.1)+step(0)", {}), 1.0);
}

TEST(Expression, TakesVariablesInTheirOrderAndConstantsByName)
{
  const Expression f("a*x-y", {"x", "y"}, {{"a", 3.0}});
  EXPECT_DOUBLE_EQ(f(std::vector<Real>{2.0, 0.5}), 5.5);
  EXPECT_DOUBLE_EQ(f(std::vector<Real>{0.0, 0.5}), -0.5);
}

TEST(Expression, KeepsItsVariablesWhenItIsMoved)
{
  Expression f("x^2", {"x"}, {});
  const Expression g = std::move(f);
  EXPECT_DOUBLE_EQ(g(std::vector<Real>{3.0}), 9.0);
}

int wrong_values_of_two_threads(const Expression& f, int n)
{
  std::atomic<int> wrong{0};
  const auto evaluate_all = [&](Real y) {
    for (int k = 0; k < n; ++k)
      if (f(std::vector<Real>{static_cast<Real>(k), y}) != static_cast<Real>(k) + 1e6 * y) ++wrong;
  };
  std::thread first(evaluate_all, 1.0), second(evaluate_all, 2.0);
  first.join(), second.join();
  return wrong;
}

TEST(Expression, GivesEachOfTwoThreadsTheValuesOfItsOwnVariables)
{
  EXPECT_EQ(wrong_values_of_two_threads(Expression("x+1e6*y", {"x", "y"}, {}), 300000), 0);
}

TEST(Expression, ItsCopiesAndManyOthersBesideItGiveTheirOwnValues)
{
  std::vector<Expression> formulas;
  for (int k = 0; k < 200; ++k)
    formulas.emplace_back("x+a", std::vector<std::string>{"x"}, std::map<std::string, Real>{{"a", k}});
  const std::vector<Expression> copies = formulas;
  for (int round = 0; round < 2; ++round)
    for (int k = 0; k < 200; ++k) {
      EXPECT_EQ(formulas[k](std::vector<Real>{0.5}), k + 0.5);
      EXPECT_EQ(copies[k](std::vector<Real>{0.25}), k + 0.25);
    }
}

TEST(Expression, OneCaseWithFormulasRunInTwoThreadsAtOnceGivesTheStatesOfOneAfterTheOther)
{
  const Case c = read_case_text(R"toml(
[time]
end = 0.1
[mesh]
size = [16.0, 3.0]
cell = 0.25
[[body]]
material = "clay"
box = [[0.0, 0.0], [8.0, 2.0]]
velocity = ["0.1*sin(pi*x/8)", "-0.05*y*x"]
[material.clay]
model = "linear_elastic"
density = 1990.0
shear_modulus = 2.0e6
poisson_ratio = 0.3
[boundary]
bottom = { velocity = ["0.01*x", "0.0"] }
)toml",
      "formulas.toml")
                     .values;
  const auto solve = [&c](StateImage& end) {
    Simulation s(c);
    s.step(5);
    end = s.save();
  };
  StateImage alone;
  solve(alone);
  for (int trial = 0; trial < 10; ++trial) {
    StateImage ends[2];
    std::thread first(solve, std::ref(ends[0])), second(solve, std::ref(ends[1]));
    first.join(), second.join();
    for (const StateImage& end : ends) ASSERT_EQ(first_difference(alone, end), "") << trial;
  }
}

TEST(Expression, OfWhatIsNoNumberIsNone)
{
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const char* text :
      {"x", "max(1,x)", "max(x,1)", "min(1,x,2)", "x < 3 ? 0 : 1", "x > 3 || 1", "step(x)", "a + 0*x"}) {
    EXPECT_TRUE(std::isnan(Expression(text, {"x", "y"}, {{"a", 1.0}})(std::vector<Real>{nan, 0.0}))) << text;
    EXPECT_TRUE(std::isnan(evaluate(text, {{"x", nan}, {"a", 1.0}}))) << text;
  }
  EXPECT_TRUE(std::isnan(evaluate("max(0,sqrt(-1))", {})));
  EXPECT_TRUE(std::isnan(evaluate("step(sqrt(-1))", {})));
  EXPECT_EQ(
      Expression("y + a", {"x", "y"}, {{"a", 1.0}})(std::vector<Real>{nan, 2.0}), 3.0);  // which it does not speak of
  EXPECT_EQ(evaluate("max(-1,-3,-2)", {}), -1.0);
  EXPECT_EQ(evaluate("min(-1,-3,-2)", {}), -3.0);
}

TEST(Expression, RefusesAConstantWithTheNameOfAVariable)
{
  EXPECT_THROW(Expression("2*p", {"p"}, {{"p", 1.0}}), ExpressionError);
  EXPECT_EQ(Expression("2*q", {"p", "q"}, {{"p", 1.0}})(std::vector<Real>{0.0, 4.0}),
      8.0);  // nobody can take the one for the other
}

TEST(Expression, NamesWhatIsNotKnownAndTheNearestName)
{
  EXPECT_EQ(fault_of("2*heigth", {{"height", 1.0}, {"h", 2.0}}),
      "`heigth` is not known here. Did you mean `height`? Names: h, height");
}

TEST(Expression, RefusesWhatIsNoFormula)
{
  EXPECT_THAT(fault_of("2*(3"), HasSubstr("parenthesis"));
  EXPECT_NE(fault_of(""), "");
  EXPECT_NE(fault_of("1 2"), "");
}

TEST(Expression, RefusesACommaThatSeparatesNoArguments)
{
  for (const char* text : {"0,5", "0,1*3", "1.5*(0,5)", "min((0,5),1)", "sin(1),2", ",1"})
    EXPECT_THAT(fault_of(text), HasSubstr("The decimal point is `.`")) << text;
  EXPECT_EQ(fault_of("2*0,5"),
      "The comma at letter 4 separates no arguments of a function. The decimal point is `.`, as in 0.5.");
  EXPECT_DOUBLE_EQ(evaluate("min(3, max(1,2), (4)) + mod(5,3)", {}), 4.0);
  EXPECT_DOUBLE_EQ(evaluate("max(2*(1+1),3)", {}), 4.0);
}

TEST(Expression, RefusesAnAssignment)
{
  for (const char* text : {"x = 1", "x=1", "x === 1", "x =< 1", "x += 1", "x == 1 && x = 2", "="}) {
    EXPECT_THAT(refusal<ExpressionError>([&] { Expression(text, {"x"}, {}); }), HasSubstr("Compare with `==`")) << text;
  }
  for (const char* text : {"x == 1", "x<=1", "x >= 1", "(x != 2) == 1", "(x==1)==(x<=1)"})
    EXPECT_EQ(Expression(text, {"x"}, {})(std::vector<Real>{1.0}), 1.0) << text;
}

}  // namespace expression_test
