// What differs between runs, in words; those of the paper's two runs are in compare_test.cpp.
#include "io/results/compare.hpp"
#include "io/results/runs.hpp"
#include <functional>

namespace compare_words_test {

TEST(CompareWords, SaysThatRunsEndAtDifferentTimes)
{
  ScratchFolder scratch;
  const auto set = [](Summary& s) { s.softened_fraction = {{0.2, 0.1}, {0.25, 0.3}}; };
  std::vector<RunResults> runs{
      read_run(write_run(scratch.path() + "/short", set)), read_run(write_run(scratch.path() + "/long", set))};
  runs[0].ledger = {{"time"}, {{0.0, 0.2}}};
  const auto text = compare_runs(runs, {"short", "long"}).text;
  EXPECT_EQ(text.front(),
      "The runs end at different times, short at 0.20 s and long at 0.25 s: what they say of the end is not of one "
      "time.");
  EXPECT_THAT(text,
      Contains(
          "At 0.2 s 10.0 % of the soil has lost more than half of what softening takes with short, 10.0 % with long."));
}

TEST(CompareWords, SaysNothingOfTheEndOfARunThatGoesOn)
{
  ScratchFolder scratch;
  std::vector<RunResults> runs{
      read_run(write_run(scratch.path() + "/done")), read_run(write_run(scratch.path() + "/going"))};
  runs[1].ledger = {{"time", "step"}, {{0.0, 0.2}, {0.0, static_cast<Real>(runs[1].summary.values.n_steps) + 1.0}}};
  EXPECT_THAT(compare_runs(runs, {"done", "going"}).text, ElementsAre(StartsWith("going has not ended;")));
}

std::vector<std::string> words_on(const std::function<void(RunResults&, RunResults&)>& change)
{
  ScratchFolder scratch;
  std::vector<RunResults> runs{read_run(write_run(scratch.path() + "/a")), read_run(write_run(scratch.path() + "/b"))};
  change(runs[0], runs[1]);
  return compare_runs(runs, {"a", "b"}).text;
}

TEST(CompareWords, SaysOfIntactBlocksNoMoreThanTheNumbersSay)
{
  const auto sentence = [](std::optional<Real> a, std::optional<Real> b) {
    for (const auto& text : words_on([&](RunResults&first, RunResults&other) {
           first.summary.values.intact_fraction = a;
           other.summary.values.intact_fraction = b;
         }))
      if (text.starts_with("Of the soil that moved, ")) return text;
    return std::string();
  };
  EXPECT_EQ(sentence(0.25, 0.0),
      "Of the soil that moved, 25.0 % is intact at the end with a (eps_eq_p below 0.01), 0.0 % with b: blocks that "
      "slide in one piece survive "
      "with a and are erased with b.");
  EXPECT_THAT(sentence(0.15, 0.25), EndsWith(": more of the blocks that slide in one piece survive with b."));
  EXPECT_THAT(
      sentence(0.24, 0.25), EndsWith("24.0 % is intact at the end with a (eps_eq_p below 0.01), 25.0 % with b."));
  EXPECT_THAT(sentence(0.0004, 0.02),
      EndsWith("less than 0.1 % is intact at the end with a (eps_eq_p below 0.01), 2.0 % with b."));
  EXPECT_EQ(sentence(0.25, {}), "");
}

TEST(CompareWords, OfMoreThanTwoCallsThemByName)
{
  ScratchFolder scratch;
  std::vector<RunResults> runs;
  for (const char* name : {"/a", "/b", "/c"}) runs.push_back(read_run(write_run(scratch.path() + name)));
  runs[0].summary.values.scheme = "mpm_mixed";
  EXPECT_THAT(compare_runs(runs, {"a", "b", "c"}).text,
      Contains("With a no point loses any of its plastic strain; with c no point loses any of its plastic strain."));
}

TEST(CompareWords, SetsTwoVerdictsInOneSentence)
{
  FloodSummary one, two;
  one.water_level = two.water_level = 4.5;
  one.verdict = FloodVerdict::damaged, one.residual_height = 4.9, one.freeboard = 0.4, one.first_time_damaged = 11.0;
  two.verdict = FloodVerdict::floods, two.residual_height = 3.7, two.freeboard = -0.8, two.first_time_below = 12.7;
  const auto sentence = [&] {
    const auto text =
        words_on([&](RunResults& a, RunResults& b) { a.summary.values.flood = one, b.summary.values.flood = two; });
    return *std::ranges::find_if(text, [](const std::string& s) { return s.find("erdict") != s.npos; });
  };
  const std::string damaged =
                        "damaged from 11.00 s on: at the end the highest ground stands at 4.90 m, 0.40 m above "
                        "the water at 4.50 m",
                    floods =
                        "floods, from 12.70 s on: at the end the highest ground stands at 3.70 m, 0.80 m below "
                        "the water at 4.50 m";
  EXPECT_EQ(sentence(),
      "They differ in the verdict: with a damaged, holds the water, " + damaged + "; with b " + floods + ".");
  withhold_verdict(one);
  EXPECT_THAT(sentence(), StartsWith("The verdicts cannot be compared: with a no verdict before the end of the run, "
                                     "damaged from 11.00 s on: so far the highest ground stands at 4.90 m"));
}

TEST(CompareWords, SaysInWhatTheCasesDiffer)
{
  EXPECT_THAT(words_on([](RunResults& a, RunResults& b) {
    a.case_toml = "scheme = \"mpm_gp\"\n[mesh]\ncell = 0.1\n[material.clay]\neta = 50\n";
    b.case_toml =
        "scheme = \"mpm_mixed\"\n[mesh]\ncell = 0.2\n[material.clay]\neta = 50.0\n[forces]\ngravity = [0.0, -1.0]\n";
  }).front(),
      "Caution: the cases differ, a against b in mesh.cell (0.1 against 0.2), forces.gravity[0] (not set against 0), "
      "forces.gravity[1] (not set against -1). What "
      "follows is not of the scheme alone.");
}

TEST(CompareWords, NamesThePointsThatRegainedStrength)
{
  const auto text = words_on([](RunResults& a, RunResults& b) {
    a.history = {
        {"A", {{"su"}, {{8.0, 5.0, 6.0}}}}, {"B", {{"su"}, {{8.0, 5.0, 5.0}}}}, {"C", {{"su"}, {{8.0, 8.1, 5.0}}}}};
    b.history = {{"A", {{"su"}, {{8.0, 5.0, 4.0}}}}};
  });
  EXPECT_THAT(text, Contains("Of the named points, A and C regained strength with a, none with b."));
}

TEST(CompareWords, MeasuresTheFrontInTheDirectionOfTheSlide)
{
  EXPECT_THAT(words_on([](RunResults& a, RunResults& b) {
    for (RunResults* run : {&a, &b}) run->summary.values.facing = Facing::left;
    a.summary.values.front_x = 3.0, b.summary.values.front_x = 3.5;
  }),
      Contains("With a the front ends 0.50 m farther than with b (3.00 m against 3.50 m)."));
}

}  // namespace compare_words_test
