#include "io/files/stability_json.hpp"
#include "io/files/files.hpp"
#include "support/test.hpp"
#include <nlohmann/json.hpp>

namespace stability_json_test {

StabilityResult result()
{
  StabilityResult r;
  r.strengths = {{"material.clay.su_peak", "Pa", 8000.0}};
  r.options.search.tolerance = 0.1;
  r.relief = 4.0, r.cell = r.given_cell = 0.5;
  r.height = 4.0, r.displacement = 0.05, r.n_points = 900, r.rest_steps = 70;
  for (const auto& [factor, verdict] : {std::pair{1.0, TrialVerdict::stable}, {1.1, TrialVerdict::undecided}}) {
    Trial trial;
    trial.factor = factor, trial.verdict = verdict, trial.reason = "why", trial.steps = 12;
    trial.windows = {{0.5, 0.01, 1e-3}, {1.0, 0.02, 5e-5}};
    enter(std::move(trial), r.search);
  }
  return r;
}

TEST(StabilityJson, HoldsTheFactorItsBracketAndTheTrials)
{
  const auto json = nlohmann::json::parse(stability_json(result(), "mpm_gp", {"cut", "title = \"x\""}));
  EXPECT_DOUBLE_EQ(json["factor_of_safety"], 1.05);
  EXPECT_EQ(json["stable_at"], 1.0);
  EXPECT_EQ(json["not_stable_at"], 1.1);
  EXPECT_EQ(json["strengths"][0]["key"], "material.clay.su_peak");
  EXPECT_EQ(json["trials"][1]["verdict"], "undecided");
  EXPECT_EQ(json["trials"][0]["displacement"][1], 0.02);
  EXPECT_EQ(json["criterion"]["displacement_scale"], 0.05);
  EXPECT_EQ(json["case_name"], "cut");
}

TEST(StabilityJson, AFactorThatWasNotFoundIsNull)
{
  StabilityResult r = result();
  r.search.not_stable.reset();
  const auto json = nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}));
  EXPECT_TRUE(json["factor_of_safety"].is_null() && json["uncertainty"].is_null());
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr("factor of safety not found: the soil stands even at 1\n"));
}

TEST(StabilityText, SaysFactorCriterionAndTrials)
{
  const std::string text = stability_text(result(), "mpm_gp");
  EXPECT_THAT(text,
      HasSubstr("factor of safety 1.050 +- 0.050   (stands at 1.000, creeps at 1.100, up to 1.100)\n  by reduction "
                "of 1 strength, mpm_gp, 900 points"));
  EXPECT_THAT(text, HasSubstr("    1.0000  stable     why\n    1.1000  undecided  why\n"));
  EXPECT_THAT(text, HasSubstr("At 1.1000 the soil still crept after 200 windows: it may stand or fail, and the +- has "
                              "room for both. Larger\n  --windows decide it.\n"));
  EXPECT_THAT(
      text, HasSubstr("what moves is 8.0 cells of 0.5 m deep,\n  and with so many it was by 0 to 17 % on slopes of "
                      "other authors. --cells 0.5,0.25 measures it.\n"));
}

TEST(StabilityText, AnUndecidedEndWidensTheUncertainty)
{
  StabilityResult r = result();
  Trial trial;
  trial.factor = 1.4, trial.verdict = TrialVerdict::failed, trial.reason = "why";
  enter(std::move(trial), r.search);
  EXPECT_THAT(stability_text(r, "mpm_gp"),
      StartsWith("factor of safety 1.050 +- 0.350   (stands at 1.000, creeps at 1.100, fails at 1.400)\n"));
  const auto json = nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}));
  EXPECT_NEAR(json["uncertainty"], 0.35, 1e-12);
  EXPECT_EQ(json["not_stable_at"], 1.1);
  EXPECT_EQ(json["failed_at"], 1.4);
}

TEST(StabilityText, SearchesOnSeveralSizesGiveTheFactorOnCellsOfNoSize)
{
  StabilityResult r = result();
  r.sizes = {{1.0, 1.15, 0.0}, {0.5, 1.1, 0.0}};
  EXPECT_THAT(stability_text(r, "mpm_gp"),
      AllOf(StartsWith("factor of safety 1.050   (1.003 to 1.069), on cells of no size\n"),
          HasSubstr(
              "  The mesh: 1.150 on cells of 1 m, 1.100 on cells of 0.5 m.\n  By the order 1.00, usual on slopes; "
              "the range is that of 0.6 to 1.4")));
  const auto mesh = nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}))["mesh"];
  EXPECT_EQ(mesh["sizes"][1]["factor"], 1.1);
  EXPECT_NEAR(mesh["extrapolated"]["factor"], 1.05, 1e-12);
  EXPECT_FALSE(mesh["extrapolated"]["order_is_observed"]);
}

TEST(StabilityText, NeverGivesMoreThanWhatFailedOnTheFinestCells)
{
  StabilityResult r = result();
  r.sizes = {{1.0, 1.05, 0.0, 1.06}, {0.5, 1.15, 0.05, 1.2}};  // finer cells gave more
  EXPECT_THAT(stability_text(r, "mpm_gp"),
      AllOf(StartsWith("factor of safety 1.050   (1.050 to 1.060), the lower one of two sizes of cells\n"),
          HasSubstr("  Finer cells gave no less, which is no error of the mesh: nothing is extrapolated")));
  const auto json = nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}));
  EXPECT_EQ(json["factor_of_safety"], 1.05);
  EXPECT_FALSE(json["mesh"]["extrapolated"]["is_extrapolated"]);
}

TEST(StabilityText, FewCellsOnOneOfTwoSizesBoundTheFactorOnly)
{
  StabilityResult r = result();
  r.sizes = {{1.0, 1.15, 0.0, 1.15, 4.0}, {0.5, 1.05, 0.05, 1.1, 8.0}};
  EXPECT_THAT(stability_text(r, "mpm_gp"),
      AllOf(StartsWith("factor of safety at most 1.100   (stands at 1.000, "),
          HasSubstr(
              "  The mesh: 1.150 on cells of 1 m, 1.050 on cells of 0.5 m.\n  What moves is 4.0 cells of 1 m deep."),
          HasSubstr("Finer cells give less; --cells 0.5,0.25 measures it.\n")));
  const auto json = nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}));
  EXPECT_TRUE(json["is_upper_bound"]);
  EXPECT_EQ(json["factor_of_safety"], 1.1);
  EXPECT_TRUE(json["mesh"]["extrapolated"].is_null());
}

TEST(StabilityText, ASearchThatWasStoppedIsNotExtrapolated)
{
  StabilityResult r = result();
  r.sizes = {{1.0, 1.15, 0.0}, {0.5, 1.1, 0.0}}, r.stopped = true;
  EXPECT_THAT(stability_text(r, "mpm_gp"), StartsWith("factor of safety 1.050 +- 0.050"));
}

TEST(StabilityText, ThreeSizesShowTheirOrderWhetherItIsUsedOrNot)
{
  StabilityResult r = result();
  r.sizes = {{2.0, 1.4, 0.0}, {1.0, 1.2, 0.0}, {0.5, 1.1, 0.0}};
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr("By the order 1.00, observed on three sizes,"));
  r.sizes[0].factor = 1.31;  // the differences hardly fall
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr("The order 0.14 that three sizes show is not used"));
  r.sizes[0].factor = 1.1;
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr("The three sizes show no order."));
}

TEST(StabilityText, SuggestsSizesThatTheMeshTakes)
{
  StabilityResult r = result();
  r.cell = 1.409, r.given_cell = 1.99230769, r.relief = 10.0;  // cells of two widths a height
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr(" --cells 1.99230769,0.996153845 measures it.\n"));
  r.given_cell = 0.0;  // a file
  EXPECT_THAT(stability_text(r, "mpm_gp"), Not(HasSubstr("--cells")));
  r = result(), r.relief = 1.0;  // two cells: four times as many are enough
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr("--cells 0.125,0.0625 measures it"));
}

TEST(StabilityText, SaysWhatTensionGivesOnTheSameCells)
{
  StabilityResult r = result();
  r.with_tension = SizedFactor{0.5, 1.155, 0.01};
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr("With tension (--with-tension) 1.155 +- 0.010"));
  r.sizes = {{1.0, 1.15, 0.0}, {0.5, 1.1, 0.0}};
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr("it is 10 % stronger on the\n  finest cells\n"));
}

TEST(StabilityText, SaysWhichSlopeFailsAndWhere)
{
  StabilityResult r = result();
  Mechanism m;
  m.factor = 1.1;
  m.moving = MovingSoil{.way = Facing::left,
      .slope = Facing::left,
      .line = {{1.0, 0.5}, {2.0, 0.0}, {3.0, 4.0}},
      .entry = {3.0, 4.0},
      .exit = {1.0, 0.5},
      .highest_x = 5.0,
      .depth = 2.5,
      .area = 7.25,
      .other_way = 0.1};
  r.mechanism = std::make_shared<const Mechanism>(m);
  m.factor = 1.05, m.moving->depth = 0.4, m.moving->area = 0.97;
  r.creep = std::make_shared<const Mechanism>(m);
  m.moving->sand = "bank";
  StabilityResult sand = r;
  sand.mechanism = std::make_shared<const Mechanism>(m);
  EXPECT_THAT(stability_text(sand, "mpm_gp"), HasSubstr("    `bank` has no cohesion: where it makes the face"));
  sand.options.rules.least_depth = 2.0;
  for (const StabilityResult& quiet : {r, sand})
    EXPECT_THAT(stability_text(quiet, "mpm_gp"), Not(HasSubstr("has no cohesion")));
  EXPECT_THAT(stability_text(r, "mpm_gp"),
      HasSubstr(
          "  mechanism at 1.1000: the slope on the left of the highest ground (x = 5.00 m) fails, its soil moves to "
          "the left\n    enters at (3.00, 4.00) m, comes out at (1.00, 0.50) m, 2.50 m deep, 7.25 m^2\n"
          "    10 % of the motion goes to the other side\n  creep at 1.0500: the slope on the left of the highest "
          "ground "
          "(x = 5.00 m) creeps"));
  EXPECT_EQ(nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}))["creep"]["depth"], 0.4);
  const auto json = nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}))["mechanism"];
  EXPECT_EQ(json["slope"], "left");
  EXPECT_EQ(json["slip_surface"][2][1], 4.0);
  EXPECT_EQ(json["area"], 7.25);
}

TEST(StabilityText, IsAnUpperBoundWhereFewCellsMove)
{
  StabilityResult r = result();
  r.relief = 2.0;  // four cells
  EXPECT_THAT(stability_text(r, "mpm_gp"),
      AllOf(StartsWith("factor of safety at most 1.100   (stands at 1.000, creeps at 1.100, up to 1.100)\n"),
          HasSubstr("What moves is 4.0 cells of 0.5 m deep. So few carry far more than the soil")));
  const auto json = nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}));
  EXPECT_TRUE(json["is_upper_bound"]);
  EXPECT_EQ(json["factor_of_safety"], 1.1) << "as the text says";
  EXPECT_NEAR(json["uncertainty"], 0.1, 1e-12);
}

TEST(StabilityText, PutsTheFactorsOfOtherMethodsBesideItsOwn)
{
  StabilityResult r = result();
  SlipPlaneCase bishop, by_hand;
  bishop.name = "flood", bishop.method = "Bishop", bishop.factor_of_safety = 1.0, by_hand.name = "by hand";
  r.slip_planes = {bishop, by_hand};
  EXPECT_THAT(stability_text(r, "mpm_gp"),
      HasSubstr("  beside the factors of other methods:\n    flood, Bishop, 1.000: this is +5.0 % from it\n  At 1.1"));
  const auto json = nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}))["other_methods"];
  EXPECT_EQ(json[0]["factor_of_safety"], 1.0);
  EXPECT_EQ(json[0]["method"], "Bishop");
  EXPECT_TRUE(json[1]["factor_of_safety"].is_null());
  r.slip_planes.clear();
  EXPECT_THAT(stability_text(r, "mpm_gp"), Not(HasSubstr("other methods")));
}

TEST(StabilityText, SaysWhatTheBracketDoesNot)
{
  StabilityResult r = result();
  const std::string creep = "No trial failed, so nothing bounds the factor from above but creep",
                    mesh = "The +- is that of the search alone";
  EXPECT_THAT(
      stability_text(r, "mpm_gp"), AllOf(HasSubstr(creep), HasSubstr(mesh), Not(HasSubstr("standard_mpm locks"))));
  EXPECT_THAT(stability_text(r, "standard_mpm"), HasSubstr("standard_mpm locks"));
  Trial failed;
  failed.factor = 1.1, failed.verdict = TrialVerdict::failed;
  enter(std::move(failed), r.search);
  EXPECT_THAT(stability_text(r, "mpm_gp"), AllOf(Not(HasSubstr(creep)), HasSubstr(mesh)));
  r.stopped = true;
  EXPECT_THAT(
      stability_text(r, "mpm_gp"), HasSubstr("The search was stopped before the bracket was as narrow as asked for"));
}

}  // namespace stability_json_test
