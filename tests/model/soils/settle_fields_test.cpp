#include "model/soils/settle_fields.hpp"
#include "support/simulations.hpp"

namespace settle_fields_test {

constexpr std::size_t su_peak = 2, eta = 4;  // numbers in the table of tresca_softening

Case with_field(ParameterField field)
{
  Case c = column("mpm_gp");
  c.materials[0].fields = {std::move(field)};
  return c;
}

std::vector<Problem> refusal_of(const Case& c)
{
  return problems_of([&] { build_model(c, 1); });
}

TEST(SettleFields, GiveTheLawTheMeanOverThePoints)
{
  const Model model = build_model(with_field({su_peak, [](Vec<2> x) { return 8e3 + 1e3 * x[1]; }}), 1);
  EXPECT_NEAR(model.description.materials[0].parameters[su_peak], 9e3, 1e-9) << "a box from y = 0 to 2 m";
  EXPECT_EQ(build_model(column("mpm_gp"), 1).ground(), nullptr) << "nothing varies";
}

TEST(SettleFields, NameThePlaceWhereAValueIsWorst)
{
  EXPECT_THAT(refusal_of(with_field({su_peak, [](Vec<2> x) { return 8e3 - 1.5e3 * x[0]; }})),
      ElementsAre(told("material.clay.su_peak", "`su_peak` is out of range in part of the soil",
          AllOf(StartsWith("It is -3925 Pa at (7.95, 0.05) m, where it is worst, at "),
              EndsWith(" points of `clay`; allowed: more than 0 Pa.\nGive it a least value: max(..., ...) in a "
                       "formula, `minimum` in shansep.")))));
  EXPECT_THAT(refusal_of(with_field({su_peak, [](Vec<2>) { return INFINITY; }})),
      ElementsAre(
          told("material.clay.su_peak", "`su_peak` is out of range in part of the soil", StartsWith("It is inf Pa"))));
  EXPECT_THAT(refusal_of(with_field({su_peak, [](Vec<2>) { return std::nan(""); }})),
      ElementsAre(told("material.clay.su_peak", "`su_peak` has no value in part of the soil",
          StartsWith("There is no value at (0.05, 0.05) m, or what it is made of is out of range there."))));
}

TEST(SettleFields, AFileThatCoversNoSoilIsRefusedAndOneThatCoversAPartIsDoubted)
{
  const auto covering = [](Vec<2> low, Vec<2> high) {
    return with_field({eta, [](Vec<2>) { return 40.0; }, "",
        {.covers = {{"eta.csv", low, high}}, .reaches = {}, .scales = {}, .situations = {}}});
  };
  EXPECT_THAT(refusal_of(covering({0.0, -5.0}, {8.0, -1.0})),
      ElementsAre(told("material.clay.eta", "the table `eta.csv` covers none of the soil",
          "Its places lie in x = 0 to 8 m, y = -5 to -1 m; `clay` lies in x = 0.05 to 7.95 m, y = 0.05 to 1.95 m. Are "
          "x "
          "and y in m, and in the axes of the case?")));
  EXPECT_THAT(warnings_from(find_uncovered_soil, covering({3.0, 0.99}, {3.0, 1.01})),  // between points
      ElementsAre(told("material.clay.eta", "the table `eta.csv` does not cover all of the soil", _)));
  EXPECT_THAT(warnings_from(find_uncovered_soil, covering({0.0, 0.0}, {6.0, 2.0})),
      ElementsAre(told("material.clay.eta", "the table `eta.csv` does not cover all of the soil",
          EndsWith("of `clay` lie outside, by up to 1.95 m. They take the value of the nearest places."))));
  EXPECT_THAT(warnings_from(find_uncovered_soil, covering({0.0, 0.0}, {8.0, 2.0})), IsEmpty());
}

}  // namespace settle_fields_test
