#include "batch/idle_sweep.hpp"

#include "batch/samples.hpp"
#include "batch/study_folder.hpp"

namespace idle_sweep_test {

TEST(IdleSweep, ValuesOfASweepThatMakeTheSameCaseAreRefused)
{
  const auto message = [](const std::string& key, const std::string& values) {
    const ScratchFolder folder;
    const std::string own = values.find("[estimator]") == std::string::npos ? "[estimator]\nkind = \"sweep\"\n" : "";
    const std::string text =
        "case = \"column.toml\"\n" + own + "[[sweep]]\nkey = \"" + key + "\"\nvalues = " + values + "\n";
    return refusal<CaseError>([&] { open_study(write_study(folder.path(), text)); });
  };
  EXPECT_THAT(message("material.clay.su_peak", "[6e3, 7e3, \"6 kPa\"]"),
      AllOf(
          HasSubstr("two values of `material.clay.su_peak` make the same case"), HasSubstr("6 kPa\" give one result")));
  EXPECT_THAT(message("output.fields.every", "[0.1, 0.2]"), HasSubstr("make the same case"));
  const std::string more =
      "\n[[sweep]]\nkey = \"material.clay.eta\"\nvalues = [2, 3, 2]\n[estimator]\nkind = "
      "\"sweep\"\nform = \"table\"";
  EXPECT_THAT(message("material.clay.su_peak", "[6e3, 6e3, 6e3]" + more),
      HasSubstr("rows 0 and 2 of the table are the same case"));
  EXPECT_THAT(message("title", "[\"a\", \"b\"]"), HasSubstr("two values of `title` make the same case"));
}

TEST(IdleSweep, AKeyOfASweepThatDoesNotActIsDoubted)
{
  const ScratchFolder folder;
  const std::string text =
      "case = \"column.toml\"\n[estimator]\nkind = \"sweep\"\n[[sweep]]\nkey = "
      "\"material.clay.k0\"\nvalues = [0.5, 0.6]\n";
  const auto doubts = find_doubts(open_study(write_study(folder.path(), text)));
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_EQ(doubts[0].what, "`material.clay.k0` decides nothing in this case");
}

}  // namespace idle_sweep_test
