// What a case file names cannot make Terp write outside its run folder, nor run anything.
#include "cli/coarse_column.hpp"

namespace paths_test {

namespace fs = std::filesystem;

/// Every file below a folder that is not below its folder "run", with its content.
std::map<std::string, std::string> files_outside_the_run(const std::string& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (!name.starts_with("run")) files[name] = entry.is_regular_file() ? text_of(entry.path().string()) : "";
  }
  return files;
}

/// A place deep enough that ".." stays within the scratch folder, with a case in it.
struct Place {
  explicit Place(const std::string& text)
  {
    fs::create_directories(scratch.path() + "/a/b/run");
    fs::remove(scratch.path() + "/a/b/run");
    write_text(scratch.path() + "/a/b/case.toml", text);
    before = files_outside_the_run(scratch.path());
  }
  Finished run(const std::vector<std::string>& more = {}) const
  {
    return test::terp(with({"run", "case.toml", "-o", "run", "-q", "-j", "1"}, more), scratch.path() + "/a/b");
  }
  /// The files that were not there before or changed, those of the run left out.
  std::vector<std::string> written() const
  {
    std::vector<std::string> names;
    for (const auto& [name, text] : files_outside_the_run(scratch.path()))
      if (!name.starts_with("a/b/run") && (!before.contains(name) || before.at(name) != text)) names.push_back(name);
    return names;
  }
  ScratchFolder scratch;
  std::map<std::string, std::string> before;
};

/// A short column whose every name is NAME.
std::string case_with_name(const std::string& name)
{
  return "title = '" + name +
         "'\nscheme = \"mpm_gp\"\ntime.end = 0.02\nmesh = { size = [2, 1], cell = 0.5 }\n[[body]]\nmaterial = '" +
         name + "'\nbox = [[0, 0], [1, 1]]\npoints_per_cell = [2, 2]\n[material.'" + name +
         "']\nmodel = \"tresca_softening\"\ndensity = 2e3\nshear_modulus = 1e6\npoisson_ratio = 0.3\nsu_peak = "
         "5e3\nsu_residual = 5e3\neta = 0\n"
         "[output.history.points]\n'" +
         name + "' = [0.1, 0.1]\n";
}

TEST(Paths, NamesInACaseFileAreNoPaths)
{
  for (const std::string name : {"../escaped", "../../escaped", "/tmp/terp_escaped", "$(touch escaped)",
           "`touch escaped`", "; touch escaped", "a/b", "|touch escaped"}) {
    const Place place(case_with_name(name));
    const Finished f = place.run();
    EXPECT_EQ(f.status, 0) << name << ": " << f.err;
    EXPECT_THAT(place.written(), IsEmpty()) << name;
    EXPECT_FALSE(fs::exists("/tmp/terp_escaped")) << name;
  }
}

TEST(Paths, ACaseFileThatIsALinkLeavesNothingBesideItsTarget)
{
  const Place place(case_with_name("clay"));
  fs::rename(place.scratch.path() + "/a/b/case.toml", place.scratch.path() + "/real.toml");
  fs::create_symlink("../../real.toml", place.scratch.path() + "/a/b/case.toml");
  succeeded(place.run());
  EXPECT_THAT(place.written(), ElementsAre("real.toml"));  // it was moved there
}

TEST(Paths, LinksInAnEarlierRunAreReplacedAndNotFollowed)
{
  const Place place(case_with_name("clay"));
  const std::string folder = place.scratch.path() + "/a/b/run", mine = place.scratch.path() + "/mine";
  write_text(mine, "mine");
  fs::create_directory(folder);
  for (const char* name : {"results.vtkhdf.series", "history.csv", "ledger.csv", "summary.json", "case.toml",
           "case.toml.tmp", "mesh.msh", "checkpoint_000000001.h5"})
    fs::create_symlink(mine, folder + "/" + name);
  succeeded(place.run({"--force"}));
  EXPECT_EQ(text_of(mine), "mine");
}

TEST(Paths, FilesThatACaseNamesAreOnlyRead)
{
  std::string text = case_with_name("clay");
  text.replace(text.find("box ="), text.find("points_per_cell = [2, 2]") + 24 - text.find("box ="),
      "points = '../../points.csv'");
  text.replace(text.find("material = 'clay'\n"), 18, "");
  const Place place(text);
  write_text(place.scratch.path() + "/points.csv", "x,y,volume,material\n0.25,0.25,0.25,clay\n");
  succeeded(place.run());
  EXPECT_EQ(text_of(place.scratch.path() + "/points.csv"), "x,y,volume,material\n0.25,0.25,0.25,clay\n");

  // The run folder has copies: it can be moved, and the originals may go.
  const std::string moved = place.scratch.path() + "/moved", again = place.scratch.path() + "/again";
  fs::rename(place.scratch.path() + "/a/b/run", moved);
  fs::remove(place.scratch.path() + "/points.csv");
  EXPECT_THAT(text_of(moved + "/case.toml"), HasSubstr("points = \"points_1.csv\""));
  EXPECT_EQ(test::terp({"resume", moved, "-q", "-j", "1"}).err, "");
  succeeded(test::terp({"report", moved, "-o", place.scratch.path() + "/page.html"}));
  succeeded(test::terp({"run", moved + "/case.toml", "-o", again, "-q", "-j", "1"}));
  EXPECT_EQ(text_of(again + "/ledger.csv"), text_of(moved + "/ledger.csv"));
  write_text(moved + "/points_1.csv", "x,y,volume,material\n0.3,0.25,0.25,clay\n");
  EXPECT_THAT(test::terp({"resume", moved}).err, HasSubstr("body[0].points (content)"));
}

TEST(Paths, ASideWhoseNameWouldBeACommandOfGmshIsRefused)
{
  const std::string mesh =
      "mesh = { polygon = [[0, 0], [2, 0], [2, 1], [0, 1]], cell = 0.5, edges = { 'a\") = {1}; SystemCall \"touch "
      "escaped\"; Physical Curve(\"b' = [0] } }";
  std::string text = case_with_name("clay");
  text.replace(text.find("mesh ="), text.find("\n[[body]]") - text.find("mesh ="), mesh);
  const Place place(text);
  EXPECT_THAT(error_with(2, place.run()), HasSubstr("a side cannot be named `a\") = {1}; SystemCall"));
  EXPECT_THAT(place.written(), IsEmpty());
  EXPECT_FALSE(fs::exists(place.scratch.path() + "/a/b/run"));
}

TEST(Paths, GmshIsCalledWithoutAShell)
{
  // A side's name that only a shell would act on reaches gmsh as it is, and comes back as the side's name.
  const std::string name = "base; touch escaped & $(touch escaped)";
  std::string text = case_with_name("clay");
  text.replace(text.find("mesh ="), text.find("\n[[body]]") - text.find("mesh ="),
      "mesh = { polygon = [[0, 0], [2, 0], [2, 1], [0, 1]], cell = 0.5, edges = { '" + name + "' = [0] } }");
  const Place place(text + "[boundary]\n'" + name + "' = \"roller\"\n");
  succeeded(place.run());
  EXPECT_THAT(place.written(), IsEmpty());
}

}  // namespace paths_test
