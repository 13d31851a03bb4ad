#include "cli/same_results.hpp"
#include "io/files/small_disk.hpp"
#include <nlohmann/json.hpp>

namespace stages_test {

const std::string soil = text_of(source_path("tests/golden/files/stages.toml")),
                  stages = text_of(source_path("tests/golden/files/two_stages.toml"));

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

}  // namespace stages_test
