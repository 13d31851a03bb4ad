#include "run/stability/factor_of_safety.hpp"
#include "support/cases.hpp"
#include "support/problems.hpp"

namespace factor_of_safety_test {

const std::atomic<bool> go{false};

/// A vertical cut of 2 m on a rough base, gamma H / S_u = 4.88.
Case cut()
{
  Case c = column_without_softening("mpm_mixed", 0.5);
  for (SideCondition& side : c.sides)
    if (side.side == "bottom") side.kind = SideKind::fixed;
  return c;
}

// That it tends to the limit load: ledger, `vertical_cut`.
TEST(FactorOfSafety, OfAVerticalCutComesWithItsMechanismAndItsSizes)
{
  int told = 0;
  const StabilityResult found = find_factor_of_safety(cut(), {.search = {0.9, 0.96, 0.02}, .rules = {}, .threads = 1},
      go, [&](const Trial&, const StabilityResult&, int left) { told += left >= 0; });
  ASSERT_TRUE(found.search.found());
  EXPECT_GT(*found.search.failed, 3.776 / 4.880) << "a mesh carries no less than the soil: bounds of limit analysis";
  EXPECT_EQ(found.strengths.size(), 1u) << "the residual strength is the peak strength";
  EXPECT_GT(told, 10);
  ASSERT_NE(found.mechanism, nullptr);
  EXPECT_EQ(found.mechanism->factor, *found.search.not_stable);
  EXPECT_EQ(found.cell, 0.5);
  EXPECT_NEAR(found.relief, 1.9, 1e-9) << "between the outer rows of points";
}

TEST(FactorOfSafety, IsBetweenWhatStandsAndWhatDoesNotAndCreepIsUncertain)
{
  StabilityResult result;
  for (const auto& [factor, verdict] :
      {std::pair{1.0, TrialVerdict::stable}, {1.1, TrialVerdict::undecided}, {1.4, TrialVerdict::failed}}) {
    Trial trial;
    trial.factor = factor, trial.verdict = verdict;
    enter(std::move(trial), result.search);
  }
  EXPECT_DOUBLE_EQ(result.factor(), 1.05);
  EXPECT_NEAR(result.uncertainty(), 0.35, 1e-12);
}

TEST(FactorOfSafety, OfParametersGivenAtEachPointIsThatOfTheNumbers)
{
  const auto find = [](const Case& c) {
    return find_factor_of_safety(c, {.search = {0.9, 0.96, 0.07}, .rules = {}, .threads = 1}, go);
  };
  Case numbers = cut();
  numbers.scheme = "mpm_gp";  // MPM-Mixed takes means of the points, which are right to round-off only
  Case fields = numbers;
  for (const std::size_t k : {std::size_t{0}, std::size_t{2}, std::size_t{3}})  // stiffness too
    fields.materials[0].fields.push_back({k, [v = numbers.materials[0].parameters[k]](Vec<2>) { return v; }});
  const StabilityResult expected = find(numbers), got = find(fields);
  EXPECT_EQ(got.rest_steps, expected.rest_steps);
  ASSERT_EQ(got.search.trials.size(), expected.search.trials.size());
  for (std::size_t k = 0; k < got.search.trials.size(); ++k) {
    const Trial &a = expected.search.trials[k], &b = got.search.trials[k];
    EXPECT_EQ(b.verdict, a.verdict);
    EXPECT_DOUBLE_EQ(b.windows.back().displacement, a.windows.back().displacement) << "factor " << a.factor;
  }
}

TEST(FactorOfSafety, OfSoilThatMayNotBeJudgedIsRefusedWithTheReasonOfItsLaw)
{
  Case c = cut();
  c.materials.push_back({"water", "newtonian_fluid", 1000.0, {2e6, 1.0, 0.0}});
  c.bodies.push_back(body("water", {9.0, 0.0}, {12.0, 0.5}));
  EXPECT_THAT(problems_of([&] { find_factor_of_safety(c, {}, go); }),
      ElementsAre(told("material.water.model", "a factor of safety cannot be found for soil of the law newtonian_fluid",
          "Because a fluid has no strength: it flows under any shear stress, however small, and no factor makes it "
          "stand.\nGive `water` another law, or leave it out: all soil of a case is judged together.")));
}

TEST(FactorOfSafety, TakesAForceOnEachPointThatStaysAndNoneThatChanges)
{
  Case c = cut();
  c.forces.body.at = [](Vec<2>, Vec<2>, Real) -> Vec<2> { return {1.0, 0.0}; };
  check_may_be_judged(c);
  c.forces.body.changes = true;
  EXPECT_THROW(check_may_be_judged(c), InputError);
}

TEST(FactorOfSafety, NeedsAStrength)
{
  Case c = cut();
  c.materials = {elastic(1e6, 0.3, 2000.0)};
  c.bodies[0].material = c.materials[0].name;
  EXPECT_THAT(problems_of([&] { find_factor_of_safety(c, {}, go); }),
      ElementsAre(told(_, "no material of this case has a strength to reduce")));
}

TEST(FactorOfSafety, DoesNotTryStrengthsThatALawCannotTake)
{
  Case c = column("mpm_gp");
  EXPECT_THROW(find_factor_of_safety(c, {.search = {0.05, 0.1, 0.01}, .rules = {}, .threads = 1}, go), RunError);
}

}  // namespace factor_of_safety_test
