#include "io/results/compare.hpp"
#include "io/results/runs.hpp"
#include <nlohmann/json.hpp>

namespace compare_test {

/// Mixed with two slides and points that regained strength, GP with one slide.
struct CompareTest : testing::Test {
  ScratchFolder scratch;
  Comparison comparison;

  CompareTest()
  {
    const std::string mixed = write_run(scratch.path() + "/mixed", [](Summary& s) {
      s.scheme = "mpm_mixed", s.front_x = 13.39, s.moved_fraction = 0.403, s.intact_fraction = 0.003,
      s.points_eps_eq_p_fell = 2, s.softened_fraction = {{0.25, 0.417}};
      s.slides = {{{.begins = 0.18, .stops = 2.0, .crest_from = 8.0, .crest_to = 6.0}, {}},
          {{.begins = 2.36, .stops = {}, .crest_from = 6.0, .crest_to = 4.1}, {}}};
    });
    const std::string gp = write_run(scratch.path() + "/gp", [](Summary& s) {
      s.front_x = 13.06, s.crest_x = 4.0, s.intact_fraction = 0.248, s.softened_fraction = {{0.25, 0.311}};
      s.slides = {{{.begins = 0.25, .stops = {}, .crest_from = 8.0, .crest_to = 6.0}, {}}};
    });
    comparison = compare_runs({read_run(mixed), read_run(gp)}, {"mixed", "gp"});
  }

  const ComparisonRow& row(const std::string& label) const
  {
    for (const ComparisonRow& r : comparison.rows)
      if (r.label == label) return r;
    throw std::out_of_range(label);
  }
};

TEST_F(CompareTest, HasARowForFrontCrestEventsPointsAuditAndCost)
{
  EXPECT_THAT(row("front at the end").values, ElementsAre(Optional(13.39), Optional(13.06)));
  EXPECT_THAT(row("x of the crest at the end").values, ElementsAre(std::nullopt, Optional(4.0)));
  EXPECT_THAT(row("first slide begins").values, ElementsAre(Optional(0.18), Optional(0.25)));
  EXPECT_THAT(row("first slide stops").values, ElementsAre(Optional(2.0), std::nullopt));
  EXPECT_THAT(row("second slide begins").values, ElementsAre(Optional(2.36), std::nullopt));
  EXPECT_THAT(row("second slide stops").values, ElementsAre(std::nullopt, std::nullopt));
  EXPECT_THAT(row("largest kinetic energy").values, Each(Optional(DoubleNear(1.25e-3, 1e-12))));
  EXPECT_THAT(row("plastic dissipation").values, Each(Optional(DoubleNear(3.75e-3, 1e-12))));
  EXPECT_THAT(row("share that moved").values, ElementsAre(Optional(DoubleNear(40.3, 1e-9)), Optional(0.0)));
  EXPECT_THAT(row("softened volume at 0.25 s").values,
      ElementsAre(Optional(DoubleNear(41.7, 1e-9)), Optional(DoubleNear(31.1, 1e-9))));
  EXPECT_THAT(row("softened volume at 0.125 s").values, ElementsAre(std::nullopt, std::nullopt));
  EXPECT_THAT(row("A: 95 % softened from").values, ElementsAre(std::nullopt, std::nullopt));
  EXPECT_THAT(row("points whose eps_eq_p ever fell").values, ElementsAre(Optional(2.0), Optional(0.0)));
  EXPECT_EQ(row("material points").digits, 0);
}

TEST_F(CompareTest, SaysTheDifferencesInWords)
{
  ASSERT_EQ(comparison.text.size(), 5);
  EXPECT_EQ(comparison.text[0],
      "The first slide begins at 0.18 s with MPM-Mixed, at 0.25 s with MPM-GP. A second begins at 2.36 s with "
      "MPM-Mixed; with MPM-GP there is none.");
  EXPECT_EQ(
      comparison.text[1], "With MPM-Mixed the front ends 0.33 m farther than with MPM-GP (13.39 m against 13.06 m).");
  EXPECT_EQ(comparison.text[2],
      "Of the soil that moved, 0.3 % is intact at the end with MPM-Mixed (eps_eq_p below 0.01), 24.8 % with MPM-GP: "
      "blocks that slide in one piece survive with "
      "MPM-GP and are erased with MPM-Mixed.");
  EXPECT_EQ(comparison.text[3],
      "At the end 41.7 % of the soil has lost more than half of what softening takes with MPM-Mixed, 31.1 % with "
      "MPM-GP.");
  EXPECT_EQ(comparison.text[4],
      "With MPM-Mixed the plastic strain fell at 2 of 5 points, so that soil regained strength, which its law forbids; "
      "with MPM-GP no point loses any of its plastic strain.");
}

TEST(CompareRuns, HasNoNumbersOfASummaryThatIsBehind)
{
  ScratchFolder scratch;
  std::vector<RunResults> runs{
      read_run(write_run(scratch.path() + "/done")), read_run(write_run(scratch.path() + "/killed"))};
  runs[1].summary.finished = false;
  runs[1].summary.values.n_steps = 0;
  for (const ComparisonRow& row : compare_runs(runs, {"done", "killed"}).rows)
    if (row.label == "share that moved" || row.label == "points whose S_u ever rose" ||
        row.label == "energy balance error") {
      EXPECT_TRUE(row.values[0].has_value()) << row.label;
      EXPECT_FALSE(row.values[1].has_value()) << row.label;
    }
}

TEST_F(CompareTest, PrintsColumnsWithADashForWhatIsNotDefined)
{
  const std::string table = comparison_table(comparison);
  EXPECT_THAT(table, AllOf(HasSubstr("mixed       gp\n"), ContainsRegex("x of the crest at the end \\[m\\] +- +4.00\n"),
                         ContainsRegex("points whose eps_eq_p ever fell +2 +0\n")));
}

TEST_F(CompareTest, IsTheSameAsJson)
{
  const auto json = nlohmann::json::parse(comparison_json(comparison));
  EXPECT_EQ(json["columns"], (std::vector<std::string>{"mixed", "gp"}));
  EXPECT_EQ(json["schemes"][1], "mpm_gp");
  EXPECT_EQ(json["rows"].size(), comparison.rows.size());
  EXPECT_EQ(json["rows"][1]["label"], "front at the end");
  EXPECT_EQ(json["rows"][1]["values"][0], 13.39);
  EXPECT_TRUE(json["rows"][3]["values"][0].is_null());
  EXPECT_EQ(json["text"].size(), 5);
}

TEST(SofteningTime, IsTheFirstAtWhichThePlasticStrainOfAPointPassesThatOfItsLaw)
{
  RunResults run;
  run.summary.values.softened_strain = 0.06;
  run.history = {{"A", {{"time", "eps_eq_p"}, {{0.0, 0.1, 0.2, 0.3}, {0.0, 0.06, 0.061, 0.02}}}},
      {"B", {{"time", "eps_eq_p"}, {{0.0, 0.1}, {0.0, std::nan("")}}}}};
  EXPECT_THAT(softening_time(run, "A"), Optional(0.2));
  EXPECT_EQ(softening_time(run, "B"), std::nullopt);
  EXPECT_EQ(softening_time(run, "C"), std::nullopt);
  run.summary.values.softened_strain = std::nullopt;  // nothing softens
  EXPECT_EQ(softening_time(run, "A"), std::nullopt);
}

TEST(CompareRuns, NamesTheStrainOfSoftenedSoilIfAllRunsHaveIt)
{
  RunResults run;
  run.history = {{"A", {{"time", "eps_eq_p"}, {{0.0}, {0.0}}}}};
  std::vector<RunResults> runs{run, run, run};
  runs[0].summary.values.softened_strain = runs[1].summary.values.softened_strain = 0.06;
  const auto has = [&](const std::string& label) {
    const Comparison c = compare_runs(runs, {"a", "b", "c"});
    return std::ranges::count(c.rows, label, &ComparisonRow::label) == 1;
  };
  EXPECT_TRUE(has("A: eps_eq_p > 0.06 from"));
  runs[1].summary.values.softened_strain = 0.1;
  EXPECT_TRUE(has("A: 95 % softened from"));
}

TEST(SchemeTitle, IsThePapersName)
{
  EXPECT_EQ(scheme_title("mpm_mixed"), "MPM-Mixed");
  EXPECT_EQ(scheme_title("mpm_gp"), "MPM-GP");
  EXPECT_EQ(scheme_title("another"), "another");
}

TEST(CaseDifferences, AreNamedByKeyWithBothValues)
{
  EXPECT_THAT(case_differences("[mesh]\ncell = 0.1\n[material.clay]\nmodel = \"tresca\"\n",
                  "[mesh]\ncell = 0.25\n[material.clay]\nmodel = \"mohr\"\neta = 2.5\n"),
      ElementsAre("mesh.cell (0.1 against 0.25)", "material.clay.model (tresca against mohr)",
          "material.clay.eta (not set against 2.5)"));
  EXPECT_THAT(case_differences("[[body]]\nbox = [[0, 0], [8, 2]]\n", "[[body]]\nbox = [[0, 0], [8.0, 3]]\n"),
      ElementsAre("body[0].box[1][1] (2 against 3)"));
}

TEST(CaseDifferences, DoNotCountWhatIsThereToBeComparedOrDoesNotChangeTheSoil)
{
  EXPECT_THAT(case_differences("title = \"a\"\nscheme = \"mpm_gp\"\n[time]\nend = 4\n[output]\nmesh = true\n",
                  "title = \"b\"\nscheme = \"mpm_mixed\"\n[time]\nend = 2\n[output]\nfields.every = 0.1\n"),
      IsEmpty());
  EXPECT_THAT(case_differences("[mesh]\ncell = 8\n", "[mesh]\ncell = 8.0\n"), IsEmpty());
  EXPECT_THAT(case_differences("not TOML", "[mesh]\ncell = 8.0\n"), IsEmpty());
}

}  // namespace compare_test
