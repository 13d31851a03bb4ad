#include "io/case/case_file.hpp"
#include "io/case/other_files.hpp"
#include "io/case/samples.hpp"
#include "model/parts/setup.hpp"
#include "run/findings/setup_warnings.hpp"
#include "support/paths.hpp"
#include "model/water/water_pressure.hpp"

namespace water_keys_test {

class WaterOnAGrid : public testing::Test {
 protected:
  WaterOnAGrid() { write("grid.csv", "x,y,value\n0,0,10\n4,0,50\n0,2,30\n4,2,90\n"); }
  void write(const std::string& name, const std::string& text) { std::ofstream(scratch_.path() + "/" + name) << text; }
  CaseFile read(const std::string& water) const
  {
    return read_case_text(small_case + "[water]\n" + water, scratch_.path() + "/case.toml");
  }
  std::string refusal(const std::string& water) const
  {
    return test::refusal<CaseError>([&] { read(water); });
  }
  const ScratchFolder scratch_;
};

TEST_F(WaterOnAGrid, IsBilinearBetweenThePlacesAndThatOfTheNearestEdgeBeyond)
{
  const WaterCase water = read("pressure = { csv = \"grid.csv\" }\n").values.water;
  const auto at = [&](Real x, Real y) { return unlimited_pressure(water, water.start, {x, y}, 3.0); };
  EXPECT_DOUBLE_EQ(at(4.0, 2.0), 90.0);
  EXPECT_DOUBLE_EQ(at(1.0, 0.5), 0.75 * (0.75 * 10.0 + 0.25 * 50.0) + 0.25 * (0.75 * 30.0 + 0.25 * 90.0));
  EXPECT_DOUBLE_EQ(at(-7.0, 1.0), 20.0);
  EXPECT_DOUBLE_EQ(at(9.0, 9.0), 90.0);
}

TEST_F(WaterOnAGrid, MayBeOfHeadsAndDifferInASituation)
{
  const WaterCase water = read(
      "head = { csv = \"grid.csv\" }\nunit_weight = 10000\n[[water.situation]]\nname = \"a\"\n"
      "pressure = { csv = \"grid.csv\" }\n[[water.situation]]\nname = \"b\"\n")
                              .values.water;
  EXPECT_DOUBLE_EQ(unlimited_pressure(water, water.start, {0.0, 1.0}, 0.0), 10000.0 * (20.0 - 1.0));
  EXPECT_DOUBLE_EQ(unlimited_pressure(water, water.situations[0], {0.0, 1.0}, 0.0), 20.0);
  EXPECT_DOUBLE_EQ(unlimited_pressure(water, water.situations[1], {0.0, 1.0}, 0.0), 10000.0 * (20.0 - 1.0));
}

TEST_F(WaterOnAGrid, IsRefusedWhereThePlacesFormNone)
{
  write("scattered.csv", "x,y,value\n0,0,10\n4,0,50\n0,2,30\n");
  EXPECT_THAT(refusal("pressure = { csv = \"scattered.csv\" }\n"), HasSubstr("the table of the water is no grid"));
  EXPECT_THAT(refusal("head = { csv = \"grid.csv\" }\npressure = \"9810*y\"\n"),
      HasSubstr("`head` does not go with `pressure`"));
  EXPECT_THAT(refusal("head = { csv = \"grid.csv\" }\nphreatic_line = [[0, 2]]\n"),
      HasSubstr("`phreatic_line` does not go with `head`"));
}

TEST_F(WaterOnAGrid, IsWarnedOfWhereItDoesNotCoverTheSoil)
{
  write("small.csv", "x,y,value\n0,0,10\n0.5,0,50\n0,0.5,30\n0.5,0.5,90\n");
  Model model = build_model(read("pressure = { csv = \"small.csv\" }\n").values, 1);
  const State state = build_state(model);
  std::string said;
  for (const Problem& warning : find_warnings(model, state)) said += warning.what + "\n" + warning.detail + "\n";
  EXPECT_THAT(said, HasSubstr("the grid `small.csv` does not cover all of the soil"));
  EXPECT_THAT(said, HasSubstr("It covers x = 0 to 0.5 m, y = 0 to 0.5 m;"));
  EXPECT_THAT(said, HasSubstr("They take the value of its nearest edge."));
}

TEST_F(WaterOnAGrid, IsCopiedIntoTheFolderOfTheRun)
{
  Node root =
      parse_toml("[water]\npressure = { csv = \"grid.csv\" }\n[[water.situation]]\nhead = { csv = \"b.csv\" }\n");
  std::vector<InputFile> files;
  EXPECT_TRUE(name_copies(root, "here", files));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(find_node(root, "water.pressure.csv")->text, "values_1.csv");
  EXPECT_EQ(find_node(root, "water.situation[0].head.csv")->text, "values_2.csv");
}

}  // namespace water_keys_test
