#include "cli/same_results.hpp"
#include "io/files/small_disk.hpp"
#include <nlohmann/json.hpp>

namespace stages_test {

const std::string soil = R"([mesh]
size = [4.0, 2.0]
cell = 0.5
[[body]]
material = "soil"
box = [[0.0, 0.0], [4.0, 1.5]]
points_per_cell = 2
[material.soil]
model = "linear_elastic"
density = 2000.0
shear_modulus = 2.0e6
poisson_ratio = 0.3
[forces]
gravity = [0.0, -9.81]
damping = { local = 0.5 }
[boundary]
left = "roller"
right = "roller"
bottom = "roller"
[[load]]
name = "q"
from = 1.0
to = 3.0
pressure = 0.0
[output]
ledger = { every = 0.02 }
checkpoint = { every = 0.1, keep = 0 }
)";

const std::string stages = R"([[stage]]
name = "settle"
until = "at_rest"
at_most = 10.0
[[stage]]
name = "load"
duration = 0.5
ramp = 0.2
set = { "load.q.pressure" = 5e3 }
)";

/// A case file in a new folder, and where its run goes.
struct Files {
  explicit Files(const std::string& text) { std::ofstream(scratch.path() + "/a.toml") << text; }
  std::string run(const std::string& name) const { return scratch.path() + '/' + name; }
  Finished solve(const std::string& name, const std::vector<std::string>& more = {}) const
  {
    return test::terp(with({"run", scratch.path() + "/a.toml", "-j", "1", "-o", run(name)}, more));
  }
  /// Those of the run `whole`, the first one first.
  std::vector<std::string> checkpoints() const
  {
    std::vector<std::string> names = names_in(run("whole"));
    std::erase_if(names, [](const std::string& name) { return !name.starts_with("checkpoint_"); });
    return names;
  }
  /// The run `whole` once more from one of its checkpoints, which ends in the same bits.
  void go_on_from(const std::string& checkpoint) const
  {
    std::filesystem::copy(run("whole"), run("again"), std::filesystem::copy_options::recursive);
    succeeded(test::terp({"resume", run("again") + '/' + checkpoint, "-j", "1"}));
    expect_same_results(run("whole"), run("again"), '/' + checkpoints().back());
    std::filesystem::remove_all(run("again"));
  }
  ScratchFolder scratch;
};

nlohmann::json summary_of(const std::string& folder)
{
  return nlohmann::json::parse(text_of(folder + "/summary.json"));
}

TEST(StagesOfARun, LeaveTheirNamesAndTheirEnds)
{
  const Files files(stages + soil);
  const Finished f = succeeded(files.solve("run"));
  EXPECT_THAT(
      f.out, AllOf(HasSubstr("  stage settle     0 to "), HasSubstr("steps, at rest\n"), HasSubstr("load: t = ")));
  EXPECT_TRUE(std::filesystem::exists(files.run("run") + "/stage_01_settle.h5"));
  EXPECT_TRUE(std::filesystem::exists(files.run("run") + "/stage_02_load.h5"));
  const auto list = summary_of(files.run("run")).at("stages");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].at("name"), "settle");
  EXPECT_EQ(list[0].at("at_rest"), true);
  EXPECT_LT(list[0].at("fastest_node"), 1e-3);
  EXPECT_EQ(list[1].at("name"), "load");
  EXPECT_TRUE(list[1].at("fastest_node").is_null());
}

TEST(StagesOfARun, AreListedByCheck)
{
  const Files files(stages + soil);
  const Finished f = succeeded(test::terp({"check", files.run("a.toml"), "-j", "1"}));
  EXPECT_THAT(f.out, HasSubstr("  stage settle   t = 0 to at most 10 s, solved in at most "));
  EXPECT_THAT(f.out, HasSubstr("  stage load     t = 10 to 10.5 s, solved in "));
  EXPECT_THAT(f.out, HasSubstr(": load.q.pressure = 5000.0\n"));
  EXPECT_THAT(f.out, AllOf(HasSubstr("  load q         0 kPa, 5 kPa in `load` on x = 1 to 3 m, 0 kN per m, on "),
                         HasSubstr(" points at y = "), Not(HasSubstr("judged at"))));
  const Finished flood = test::terp(
      {"check", files.run("a.toml"), "-j", "1", "--set", "flood.water_level=0.4", "--set", "flood.river=\"left\""});
  EXPECT_THAT(flood.out, AllOf(HasSubstr("  flood          judged at 0.4 m, "), HasSubstr(", river on the left\n")));
}

TEST(StagesOfARun, GoOnWithinAnyStageWithTheSameBits)
{
  const Files files(stages + soil);
  succeeded(files.solve("whole", {"-q"}));
  const auto checkpoints = files.checkpoints();
  ASSERT_GT(checkpoints.size(), 4u);
  for (const std::size_t k : {std::size_t{1}, checkpoints.size() - 6, checkpoints.size() - 2})
    files.go_on_from(checkpoints[k]);
}

TEST(StagesOfARun, AreBeginningsOfOtherRuns)
{
  const Files files(stages + soil);
  succeeded(files.solve("whole", {"-q"}));
  succeeded(files.solve("part", {"--from", files.run("whole") + ":settle"}));
  const StateImage a = read_checkpoint(files.run("whole") + "/stage_02_load.h5"),
                   b = read_checkpoint(files.run("part") + "/stage_02_load.h5");
  for (const NamedArray& array : a.arrays)
    if (array.name.starts_with("points/") || array.name == "work") {
      const auto there = std::ranges::find(b.arrays, array.name, &NamedArray::name);
      ASSERT_NE(there, b.arrays.end());
      EXPECT_TRUE(there->values == array.values) << array.name;
    }
  succeeded(files.solve(
      "other", {"--from", files.run("whole") + ":settle", "--set", "material.soil.shear_modulus=8e6", "-q"}));
  succeeded(test::terp({"resume", files.run("other"), "-j", "1"}));
}

TEST(StagesOfARun, GoOnWhereTheyBeganWithAnotherRun)
{
  for (const std::string& end : {std::string("[time]\nend = 0.4\n"), stages}) {
    const Files files(end + soil);
    const std::vector<std::string> brief{"-q", "--set", "initial.stress=\"k0\""};
    succeeded(files.solve("first", brief));
    std::vector<std::string> more{"--from", files.run("first") + (end == stages ? "/stage_02_load.h5" : "")};
    if (end == stages) more = with(more, {"--set", "stage[1].name=\"other\"", "--set", "stage[0].ramp=0.3"});
    succeeded(files.solve("whole", with(brief, more)));
    const auto checkpoints = files.checkpoints();
    ASSERT_GT(checkpoints.size(), 2u);
    for (const std::size_t k : {std::size_t{0}, checkpoints.size() - 2}) files.go_on_from(checkpoints[k]);
  }
}

TEST(StagesOfARun, ThatAreNoBeginningAreRefused)
{
  const Files files(stages + soil);
  succeeded(files.solve("whole", {"-q"}));
  EXPECT_THAT(error_with(1, files.solve("a", {"--from", files.run("whole") + ":flood"})),
      HasSubstr("no stage `flood` of this run has ended\n  Stages that have: load, settle"));
  EXPECT_THAT(error_with(1, files.solve("b", {"--from", files.run("nowhere")})),
      HasSubstr("there is no such run or checkpoint\n  Give RUN:STAGE"));
  EXPECT_THAT(error_with(1, files.solve("b", {"--from", files.run("whole") + "/case.toml"})),
      HasSubstr("/case.toml: this is a case file; give the run to begin with: RUN, RUN:STAGE"));
  const Finished mesh = files.solve("c", {"--from", files.run("whole") + ":settle", "--set", "mesh.cell=0.25"});
  EXPECT_EQ(mesh.status, 1);
  EXPECT_THAT(mesh.err, HasSubstr("it is of another mesh, other bodies or another scheme\n  mesh.cell ([0.5, 0.5], now "
                                  "[0.25, 0.25])"));
  EXPECT_THAT(error_with(2, files.solve("d", {"--from", files.run("whole") + ":load"})),
      HasSubstr("the run begins with the end of the stage `load`, the last of this case"));
  std::ofstream(files.run("whole") + "/case.toml", std::ios::app) << "[flood]\nwater_level = 1.0\n";
  const std::string changed = error_with(1, files.solve("e", {"--from", files.run("whole") + ":settle"}));
  EXPECT_THAT(changed, HasSubstr("/case.toml was changed since that run began\n"));
  EXPECT_THAT(changed, HasSubstr("\n  flood.water_level (not set, now 1"));
  std::filesystem::remove(files.run("whole") + "/case.toml");
  EXPECT_THAT(error_with(1, files.solve("f", {"--from", files.run("whole") + ":settle"})),
      HasSubstr("there is no case.toml beside it\n  What the soil of the checkpoint is made of"));
}

TEST(ARunUntilRest, EndsThereOrSaysThatItDidNot)
{
  const Files files("[time]\nuntil = \"at_rest\"\nat_most = 10.0\n" + soil);
  EXPECT_THAT(succeeded(files.solve("run")).out, HasSubstr(", at rest\n"));
  EXPECT_EQ(summary_of(files.run("run")).at("finished"), true);
  EXPECT_THAT(succeeded(files.solve("late", {"--set", "time.at_most=0.1", "--set", "time.rest_time=0.05"})).err,
      HasSubstr("late: the run ended after 0.1 s, at t = 0.1 s, before the soil was at rest: its "
                "fastest node moved with "));
  EXPECT_EQ(summary_of(files.run("late")).at("stages").at(0).at("at_rest"), false);
  const Finished brief = files.solve("brief", {"--set", "time.at_most=0.1", "--set", "time.rest_speed=1e3"});
  EXPECT_THAT(brief.err, HasSubstr("its fastest node was not slower than 1e+03 m/s for 0.5 s after the last change"));
  const Finished far = files.solve("far", {"--set", "time.at_most=0.1", "--set", "time.rest_by=\"mean\""});
  EXPECT_THAT(far.err, HasSubstr("at rest: more of it than a cell holds went farther than 0.0005 m within 0.5 s; see"));
}

TEST(ARunWithAFixedEnd, WarnsOfAVerdictOnSoilThatStillMoves)
{
  const Files files("[time]\nend = 0.3\n[flood]\nwater_level = 0.1\n" + soil);
  const Finished early =
      succeeded(files.solve("early", {"--set", "initial.stress=\"none\"", "--set", "material.soil.shear_modulus=2e4"}));
  EXPECT_THAT(early.err, HasSubstr("early: at the end `soil` moves with "));
  EXPECT_THAT(early.out, HasSubstr("still moving, not decided, damaged from "));
  const Finished rested = succeeded(files.solve("rested", {"--set", "time.end=10.0"}));
  EXPECT_EQ(summary_of(files.run("rested")).at("flood").at("still_moves"), false);
  EXPECT_THAT(rested.err, testing::Not(HasSubstr("nothing is decided")));
  EXPECT_EQ(summary_of(files.run("early")).at("flood").at("verdict"), "still_moving");
  EXPECT_EQ(summary_of(files.run("early")).at("flood").at("fastest_soil"), "soil");
}

TEST(ARunWithAVerdict, WarnsOfDamagedGroundJustAboveTheWater)
{
  const Files files("[time]\nend = 2.0\n[flood]\n" + soil);  // 1.5 m of soil, which settles by 0.06 m
  const auto solved = [&](const std::string& name, const std::string& level) {
    return files.solve(name, {"--set", "initial.stress=\"none\"", "--set", "material.soil.shear_modulus=1e5", "--set",
                                 "forces.damping.local=0.9", "--set", "flood.water_level=" + level});
  };
  const Finished close = succeeded(solved("close", "1.41"));
  EXPECT_THAT(close.out, HasSubstr("damaged, holds the water"));
  EXPECT_THAT(close.err, HasSubstr("close: the ground that remains is only 0.03 m higher than holds the water: "));
  EXPECT_THAT(solved("far", "1.3").err, testing::Not(HasSubstr("only")));
}

}  // namespace stages_test
