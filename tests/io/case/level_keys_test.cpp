// River levels as a table: water.level.
#include "io/case/samples.hpp"
#include "support/paths.hpp"

namespace level_keys_test {

const std::string dike = replaced(replaced(small_case, "box = [[0.0, 0.0], [8.0, 2.0]]",
                                      "polygon = [[0.0, 0.0], [16.0, 0.0], [16.0, 0.5], [12.0, 0.5], [9.0, 2.0], [7.0, "
                                      "2.0], [4.0, 0.5], [0.0, 0.5]]"),
    "end = 4.0", "end = 4.0");

class LevelKeys : public testing::Test {
 protected:
  std::string message(const std::string& table, const std::string& keys)
  {
    write(table);
    try {
      const CaseFile file = read(keys);
      return "accepted " + file.notes.back() + render_warnings(file);
    } catch (const CaseError& error) {
      return error.what();
    }
  }

  CaseFile read(const std::string& keys)
  {
    return read_case_text(
        dike + "[water]\nlevel = { csv = \"levels.csv\"" + keys + " }\n", folder_.path() + "/case.toml");
  }

  void write(const std::string& table) { std::ofstream(folder_.path() + "/levels.csv") << table; }

  ScratchFolder folder_;
};

TEST_F(LevelKeys, BecomeSituationsInTime)
{
  write("time,level\n0,0.6\n2,1.6\n4,1.0\n");
  const CaseFile file = read("");
  const WaterCase& water = file.values.water;
  EXPECT_THAT(file.notes, Contains("water.level: 3 levels in 4 h, from 0.600 m to 1.600 m at 2 h; 1 h takes 1 s"));
  ASSERT_EQ(water.situations.size(), 2u);
  EXPECT_EQ(water.situations[0].time, 2.0);
  EXPECT_EQ(water.situations[1].time, 4.0);
  // The level up to the outer slope of 1:2, straight to the toe at 12 m, the land beyond.
  const std::vector<Vec<2>>& line = water.situations[0].phreatic_line;
  ASSERT_EQ(line.size(), 4u);
  EXPECT_NEAR(line[1][0], 6.2, 0.03);
  EXPECT_EQ(line[1][1], 1.6);
  EXPECT_NEAR(line[2][0], 12.0, 0.3);
  EXPECT_EQ(line[3][1], 0.5);
}

TEST_F(LevelKeys, HaveTheirUnitTheirSideAndALineByFormulas)
{
  write("0;1,25\n60;1,5\n");
  const CaseFile file = read(
      R"(, unit = "min", shorten = 1800, side = "right", phreatic_line = [[0, 0.25], [8, "level/2"], [16, "level"]])");
  const WaterSituation& last = file.values.water.situations.at(0);
  EXPECT_EQ(last.time, 2.0);
  EXPECT_THAT(last.phreatic_line, ElementsAre(Vec<2>{0.0, 0.25}, Vec<2>{8.0, 0.75}, Vec<2>{16.0, 1.5}));
  EXPECT_EQ(file.values.water.start.phreatic_line[2][1], 1.25);
}

TEST_F(LevelKeys, TakeDatesAndLeaveGapsOut)
{
  EXPECT_THAT(message("tijd;stand\n31-12-2025 23:00;0,6\n2026-01-01 01:00;\n2026-01-01T02:00:00Z;1,0\n", ""),
      HasSubstr("2 levels in 3 h, from 0.600 m to 1.000 m at 3 h"));
  EXPECT_THAT(message("tijd;stand\n31-12-2025 23:00;0,6\n2026-01-01 01:00;\n2026-01-01T02:00:00Z;1,0\n", ""),
      HasSubstr("1 row without a level"));
}

TEST_F(LevelKeys, ThatCannotBeUsedAreRefusedWithTheirLine)
{
  EXPECT_THAT(message("time,level\n0,1\n0,2\n", ""), HasSubstr("levels.csv:3: the times do not grow"));
  EXPECT_THAT(message("time,level\n0,1\nnoon,2\n", ""), HasSubstr("`noon` is no time"));
  EXPECT_THAT(message("time,level\n0,1\n1,high\n", ""), HasSubstr("`high` is no level"));
  EXPECT_THAT(message("time,level\n0,1\n", ""), HasSubstr("a series has two or more"));
  EXPECT_THAT(message("0,1\n1,2\n", ", unit = \"week\""), HasSubstr("`unit` must be one of"));
  EXPECT_THAT(message("0,1\n1,2\n", ", phreatic_line = [[0, \"lvel\"]]"), HasSubstr("lvel"));
  EXPECT_THAT(message("0,1\n100,2\n", ""), HasSubstr("the run ends before the series"));
}

}  // namespace level_keys_test
