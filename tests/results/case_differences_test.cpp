#include "results/compare.hpp"
#include "support/test.hpp"

namespace case_differences_test {

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

}  // namespace case_differences_test
