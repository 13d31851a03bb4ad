#include "support/process.hpp"

namespace import_folder_test {

struct ImportFolder : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/section";
};

TEST_F(ImportFolder, HoldsTheSoilAsAskedAlsoWhereTheTriggerIsLookedFor)
{
  const Finished f =
      succeeded(test::terp({"import", source_path("tests/import/dstability/samples/example-2020.03-v1.stix"), "--cell",
          "8", "--held", "--trigger", "strength", "-o", folder}));
  EXPECT_THAT(text_of(folder + "/case.toml"),
      AllOf(HasSubstr("at_strength = 0.5"), HasSubstr("\"release\""), HasSubstr("\"weaker_soil\"")));
  EXPECT_THAT(f.err, HasSubstr("warning: The soil is held at first"));
}

/// A study of the file's distributions that the program takes as it is written.
TEST_F(ImportFolder, HasAStudyThatCanBeRun)
{
  const std::string file = source_path("tests/import/dstability/samples/tutorial-2023.stix");
  const Finished f = succeeded(test::terp({"import", file, "--study", "--scenario", "2", "--cell", "4", "-o", folder}));
  EXPECT_THAT(f.out, HasSubstr("terp study check"));
  const Finished check = succeeded(test::terp({"study", "check", folder + "/study.toml"}));
  EXPECT_THAT(check.out, AllOf(HasSubstr("S_clay_shallow: lognormal"), HasSubstr("realisation 0  can be solved")));
  EXPECT_THAT(check.err, Not(HasSubstr("error")));
  for (const std::vector<std::string>& wrong :
      {std::vector<std::string>{"--strength", "design"}, {"--trigger", "water"}}) {
    std::vector<std::string> words{"import", file, "--study", "--scenario", "2", "-o", folder, "--force"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const Finished refused = test::terp(words);
    EXPECT_NE(refused.status, 0);
    EXPECT_THAT(refused.err, HasSubstr(wrong[0] + " does not go with --study"));
  }
}

}  // namespace import_folder_test
