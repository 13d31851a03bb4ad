// terp check: what would run, without running it.
#include "app/coarse_column.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using test::Finished;
using testing::AllOf;
using testing::HasSubstr;

TEST(Check, TellsWhatWouldRun)
{
  const test::ScratchFolder folder;
  const Finished f = test::terp(test::column_command("check"), folder.path());
  EXPECT_EQ(f.status, 0);
  for (const char* line : {"  scheme         mpm_gp\n", "  mesh           192 cells, 231 nodes\n", "  cells of soil  64\n",
                           "  points         1600\n", "  mass           31840 kg per m\n", "  time step      0.00303 s\n",
                           "  steps          66 to t = 0.2 s\n", "nothing was run\n"})
    EXPECT_THAT(f.out, HasSubstr(line));
  EXPECT_THAT(f.out, HasSubstr("  smallest cell  0.5 m high, "));
  EXPECT_THAT(f.out, testing::ContainsRegex("  memory         [0-9]+ MB\n"));
  EXPECT_THAT(f.out, testing::ContainsRegex("  expected time  [0-9.]+ s on 1 thread [(][0-9.]+ M point-steps/s in a trial[)]\n"));
  EXPECT_TRUE(test::names_in(folder.path()).empty());
}

TEST(Check, SaysWhereABodyLiesOutsideTheMesh)
{
  const Finished f = test::terp(test::column_command("check", {"--set", "mesh.size=[6.0, 3.0]"}));
  EXPECT_EQ(f.status, 2);
  EXPECT_THAT(f.err, AllOf(HasSubstr("model_2.toml:"), HasSubstr("the body lies outside the mesh"), HasSubstr("Enlarge mesh.size")));
  EXPECT_EQ(f.out, "");
}

}  // namespace
}  // namespace terp
