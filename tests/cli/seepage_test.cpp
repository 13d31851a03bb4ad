#include "support/process.hpp"

namespace seepage_test {

const std::string dike = source_path("tests/support/seeping.toml");

std::size_t rows_that_begin_with(const std::string& text, const std::string& start)
{
  std::size_t n = 0;
  for (std::size_t at = text.find("\n" + start); at != text.npos; at = text.find("\n" + start, at + 1)) ++n;
  return n;
}

TEST(Seepage, LeavesFlowsHeadsUpliftAndAPicture)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/out";
  const std::string said = succeeded(test::terp({"seepage", dike, "--along", "0,-5,40,-5", "-o", folder})).out;
  EXPECT_THAT(said, AllOf(HasSubstr("river"), HasSubstr("uplift: least factor "), HasSubstr("results in " + folder)));
  EXPECT_THAT(names_in(folder), ElementsAre("along.csv", "case.toml", "heads_start.csv", "seepage.csv",
                                    "seepage_start.svg", "table_start.csv", "uplift.csv"));
  const std::string along = text_of(folder + "/along.csv");
  EXPECT_THAT(along, StartsWith("situation,x_m,y_m,head_m,pore_pressure_Pa\nstart,0,-5,1.99999")) << "the head there";
  EXPECT_EQ(rows_that_begin_with(along, "start,"), 201u);
}

TEST(Seepage, FollowsLevelsOverHours)
{
  const ScratchFolder scratch;
  write_text(scratch.path() + "/levels.csv", "hours,river\n0,1\n2,3\n");
  const std::string folder = scratch.path() + "/out";
  succeeded(test::terp(
      {"seepage", dike, "--levels", scratch.path() + "/levels.csv", "--along", "0,-5,40,-5", "-o", folder, "-q"}));
  const std::string along = text_of(folder + "/along.csv");
  for (const char* hour : {"0,", "1,", "2,"}) EXPECT_EQ(rows_that_begin_with(along, hour), 201u) << hour;
}

TEST(Seepage, RefusesALineBesideTheSoilAndHoursWithoutLevels)
{
  const ScratchFolder scratch;
  const auto said = [&](const std::vector<std::string>& more) {
    return error_with(2, test::terp(with({"seepage", dike, "-o", scratch.path() + "/out", "-q"}, more)));
  };
  EXPECT_THAT(said({"--along", "50,0,60,0"}),
      AllOf(HasSubstr("the line of --along meets no soil"), HasSubstr("reaches from x = 0 to 40 m")));
  EXPECT_THAT(said({"--along", "50,0,60"}), HasSubstr("--along takes four numbers"));
  EXPECT_THAT(said({"--at", "2"}), HasSubstr("--at is for --levels"));
}

}  // namespace seepage_test
