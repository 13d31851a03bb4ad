// What is measured of a run, beyond what terp compare shows of it (compare_test.cpp).
#include "io/results/measures.hpp"
#include "io/results/mesh_study.hpp"
#include "io/results/runs.hpp"
#include "support/scratch.hpp"

namespace measures_test {

const RunMeasure& measure(const std::vector<RunMeasure>& all, const std::string& name)
{
  for (const RunMeasure& m : all)
    if (m.name == name) return m;
  throw std::out_of_range(name);
}

using Measures = ScratchTest;

TEST_F(Measures, HaveNamesOfTheirOwnAndWordsWhereTheyAreWords)
{
  const std::vector<RunResults> runs{read_run(write_run(scratch.path() + "/run"))};
  std::set<std::string> names;
  for (const RunMeasure& m : measures_of(runs)) {
    EXPECT_FALSE(m.label.empty() || m.unit.empty()) << m.name;
    EXPECT_TRUE(m.name.empty() || names.insert(m.name).second) << m.name;
    EXPECT_EQ(m.kind == MeasureKind::word, !m.words.empty()) << m.name;
    EXPECT_EQ(m.kind == MeasureKind::place, static_cast<bool>(m.distance)) << m.name;
  }
}

TEST_F(Measures, TakeNoInputForAResult)
{
  std::string named;
  for (const RunMeasure& measure : measures_of({})) {
    EXPECT_TRUE(measure.name.empty() || !measure.label.starts_with("softening length over")) << measure.label;
    named += measure.name + ' ';
  }
  EXPECT_THAT(named, HasSubstr(" halo_fraction "));
}

TEST_F(Measures, OfFollowersAreNotDefinedWhileTheSummaryIsBehind)
{
  RunResults run;
  run.summary.values.numbers["halo_fraction"] = 0.25;
  run.summary.values.n_steps = 1;
  const auto all = measures_of({run});
  EXPECT_THAT(measure(all, "halo_fraction").value(run), Optional(0.25));
  run.summary.values.n_steps = 0;
  EXPECT_EQ(measure(all, "halo_fraction").value(run), std::nullopt);
}

TEST_F(Measures, OfEverySlideThatSomeRunHas)
{
  const std::vector<RunResults> runs{
      read_run(write_run(scratch.path() + "/one")), read_run(write_run(scratch.path() + "/three", [](Summary& s) {
        s.slides.resize(3);
        s.slides[2].slide.begins = 3.5, s.slides[2].slide.stops = 4.0;
      }))};
  const auto all = measures_of(runs);
  EXPECT_EQ(measure(all, "slide_3_begins").label, "third slide begins");
  EXPECT_THAT(measure(all, "slide_3_stops").value(runs[1]), Optional(4.0));
  EXPECT_EQ(measure(all, "slide_3_begins").value(runs[0]), std::nullopt);
  EXPECT_THAT(measure(all, "slides").value(runs[1]), Optional(3.0));
}

TEST_F(Measures, SetDampingAgainstTheWorkOfGravityAndForcesOfFootings)
{
  RunResults run;
  run.ledger = {{"time", "gravity_work", "damping_work"}, {{0.0, 1.0}, {0.0, 200e3}, {0.0, -30e3}}};
  run.summary.finished = true, run.summary.values.n_steps = 1;
  run.summary.values.footings = {{.name = "pad", .displacement = {}, .reaction = {}, .largest = 51e3}};
  const auto all = measures_of({run});
  EXPECT_THAT(measure(all, "damping_share").value(run), Optional(DoubleNear(15.0, 1e-12)));
  EXPECT_THAT(measure(all, "gravity_work").value(run), Optional(200.0));
  EXPECT_NEAR(measure(all, "gravity_work").resolution(run, 0.1), 0.2, 1e-12);
  EXPECT_THAT(measure(all, "footing_pad").value(run), Optional(51.0));
  EXPECT_NEAR(measure(all, "slide_1_begins").resolution(run, 0.1), 1.0, 1e-12);
  run.ledger.columns[1] = {0.0, 0.0};  // no gravity
  EXPECT_EQ(measure(all, "damping_share").value(run), std::nullopt);
}

TEST_F(Measures, MeasureTheCrestFromItsFirstPlaceOnTheSlopeThatSlides)
{
  RunResults run;
  run.ledger = {{"crest_x", "crest_left_x"}, {{8.0, 7.0}, {2.0, 3.5}}};
  run.summary.values.crest_x = 3.5;
  run.summary.values.facing = Facing::left;
  EXPECT_THAT(measure(measures_of({run}), "crest_x").distance(run), Optional(1.5));
  run.summary.values.facing = Facing::right;
  EXPECT_THAT(measure(measures_of({run}), "crest_x").distance(run), Optional(4.5));
  EXPECT_THAT(measure(measures_of({run}), "facing").value(run), Optional(1.0));
}

/// A run whose ground was asked to hold the water.
RunResults flooding(const std::string& folder, FloodVerdict verdict, Real height)
{
  RunResults run = read_run(write_run(folder));
  FloodSummary& flood = run.summary.values.flood.emplace();
  flood.verdict = verdict, flood.water_level = 4.0, flood.residual_height = height, flood.freeboard = height - 4.0;
  run.summary.values.residual_height = height;
  return run;
}

TEST_F(Measures, TheVerdictOnTheWaterIsAWord)
{
  const std::vector<RunResults> runs{flooding(scratch.path() + "/run", FloodVerdict::damaged, 4.5)};
  const auto all = measures_of(runs);
  const RunMeasure& verdict = measure(all, "flood_verdict");
  EXPECT_EQ(verdict.words[static_cast<std::size_t>(*verdict.value(runs[0]))], "damaged, holds the water");
  EXPECT_EQ(measure(all, "freeboard").value(runs[0]), 0.5);
  EXPECT_EQ(measure(all, "residual_height").value(runs[0]), 4.5);
  EXPECT_FALSE(measure(all, "first_time_below").value(runs[0]));
  RunResults stopped = runs[0];
  stopped.summary.values.flood->verdict.reset();
  EXPECT_FALSE(verdict.value(stopped));
}

TEST_F(Measures, TheStageOfTheVerdictIsAWord)
{
  std::vector<RunResults> runs;
  for (const char* name : {"/a", "/b", "/c"})
    runs.push_back(flooding(scratch.path() + name, FloodVerdict::floods, 3.5));
  EXPECT_THAT(
      measures_of(runs), Each(testing::Field(&RunMeasure::name, testing::Ne("stage_below"))));  // runs without stages
  runs[0].summary.values.flood->stage_below = "daily", runs[1].summary.values.flood->stage_below = "flood";
  const auto all = measures_of(runs);
  const RunMeasure& stage = measure(all, "stage_below");
  EXPECT_EQ(stage.words[static_cast<std::size_t>(*stage.value(runs[0]))], "daily");
  EXPECT_EQ(stage.words[static_cast<std::size_t>(*stage.value(runs[1]))], "flood");
  EXPECT_FALSE(stage.value(runs[2]));
}

TEST_F(Measures, OfSizesWhoseVerdictDiffersSayItLoudly)
{
  const auto study = [&](FloodVerdict fine) {
    StudySequence sequence;
    sequence.name = "mpm_gp";
    for (const auto& [cell, verdict] : {std::pair{0.5, FloodVerdict::damaged}, std::pair{0.25, fine}}) {
      StudyRun& run = sequence.runs.emplace_back();
      run.cell = run.size = cell;
      run.results = flooding(scratch.path() + fmt::format("/{}_{}", cell, static_cast<int>(fine)), verdict, 4.5);
    }
    return study_text(study_mesh({sequence}, 0.05));
  };
  EXPECT_THAT(study(FloodVerdict::floods),
      HasSubstr(
          "\nWHETHER IT FLOODS CHANGES WITH THE MESH: damaged, holds the water, floods on cells of 0.5, 0.25 m. "));
  EXPECT_THAT(study(FloodVerdict::damaged), HasSubstr("\nAll sizes agree: damaged, holds the water. "));
}

}  // namespace measures_test
