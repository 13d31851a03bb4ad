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

}  // namespace import_folder_test
