#include "support/laws.hpp"
#include "support/process.hpp"

#include <csignal>

namespace user_law_test {

/// A case with wrong_umat.c beside it. kind, time: what its law does wrong, from when [s].
class UserLawProgram : public testing::Test {
 protected:
  UserLawProgram() { std::filesystem::copy(law_folder() + "/wrong_umat.so", path("law.so")); }

  std::string path(const std::string& name) const { return scratch_.path() + '/' + name; }

  std::string case_with(int kind, double time) const
  {
    std::ofstream(path("case.toml"))
        << "[time]\nend = 0.2\n[mesh]\nsize = [4.0, 2.0]\ncell = 0.5\n[[body]]\nmaterial = \"clay\"\n"
           "box = [[0.0, 0.0], [2.0, 1.0]]\n[material.clay]\nmodel = \"library\"\nlibrary = \"law.so\"\n"
           "interface = \"umat\"\nparameters = [2e6, 0.3, "
        << kind << ", " << time
        << ", -1.0, 0.0]\nstate = { calls = 3.0 }\ndensity = 1990.0\nshear_modulus = 2e6\npoisson_ratio = 0.3\n"
           "[forces]\ngravity = [0.0, -9.81]\n[boundary]\nbottom = \"fixed\"\n[output]\ncheckpoint = { every = 0.05, "
           "keep = 0 }\n";
    return path("case.toml");
  }

  const ScratchFolder scratch_;
};

TEST_F(UserLawProgram, ShearsTheOneCellOfTheExample)
{
  if (!is_built("tresca.so")) GTEST_SKIP() << "built without gfortran";
  std::filesystem::copy(law_folder() + "/tresca.so", path("tresca.so"));
  std::filesystem::copy(test::source_path("cases/user_law/one_cell.toml"), path("one_cell.toml"));
  EXPECT_EQ(succeeded(test::terp({"run", path("one_cell.toml"), "-q", "-o", path("run")})).err, "");
  succeeded(test::terp({"export", path("run"), "--field", "stress", "--frames", "1,5,last"}));
  for (const auto& [frame, by_hand] : std::map<std::string, std::string>{
           {"frame_00001", ",7272.727\n"}, {"frame_00005", ",5856.719"}, {"frame_00050", ",2041.472"}})
    EXPECT_THAT(text_of(path("run/csv/" + frame + ".csv")), HasSubstr(by_hand)) << "docs/user_laws.md has the numbers";
}

TEST_F(UserLawProgram, ResumesInAFolderThatWasMovedWithTheSameBits)
{
  const std::string file = case_with(0, 0.0);
  succeeded(test::terp({"run", file, "-q", "-o", path("whole")}));
  succeeded(test::terp({"run", file, "-q", "-o", path("part"), "--set", "time.end=0.2"}));
  std::filesystem::rename(path("part"), path("moved"));
  std::filesystem::remove(path("law.so"));
  std::filesystem::path first;
  for (const auto& entry : std::filesystem::directory_iterator(path("moved")))
    if (entry.path().filename().string().starts_with("checkpoint_") && (first.empty() || entry.path() < first))
      first = entry.path();
  succeeded(test::terp({"resume", first.string(), "-q"}));
  EXPECT_EQ(text_of(path("moved/ledger.csv")), text_of(path("whole/ledger.csv")));
}

}  // namespace user_law_test
