#include "io/element/element_csv.hpp"

#include "io/element/element_case.hpp"
#include "model/bodies/csv_rows.hpp"
#include "support/problems.hpp"

namespace element_csv_test {

constexpr PathFileOptions from_100_kPa{.stress = {-100e3, -100e3, -100e3, 0.0}};

std::string fault_of(const std::string& text)
{
  try {
    read_path_csv_text("path.csv", text, from_100_kPa);
  } catch (const CsvError& error) {
    return error.what();
  }
  return {};
}

TEST(PathCsv, ARowPrescribesAStrainOrAStressOfEachComponent)
{
  const ElementPath path = read_path_csv_text("path.csv",
      "# of the laboratory\ntime, strain_yy, stress_xx, strain_xx\n10, -0.01, -90e3,\n15, -0.02, , 0.005\n",
      from_100_kPa);
  ASSERT_EQ(path.legs.size(), 2);
  const ElementLeg &first = path.legs[0], &second = path.legs[1];
  EXPECT_EQ(first.control[0], Control::stress);
  EXPECT_EQ(first.target[0], -90e3);
  EXPECT_EQ(first.control[1], Control::strain);
  EXPECT_EQ(first.target[1], -0.01);
  EXPECT_EQ(first.control[2], Control::strain);
  EXPECT_TRUE(std::isnan(first.target[2])) << "it keeps its strain";
  EXPECT_EQ(second.control[0], Control::strain);
  EXPECT_EQ(second.target[0], 0.005);
  EXPECT_EQ(first.duration, 10.0);
  EXPECT_EQ(second.duration, 5.0);
  EXPECT_EQ(first.increments, 500);
}

TEST(PathCsv, FaultsAreSaidWithTheirLine)
{
  using testing::HasSubstr;
  EXPECT_THAT(fault_of("strain_xx,stress_xx\n0.1,5\n"), HasSubstr("path.csv:2: strain and stress xx are both given"));
  EXPECT_THAT(fault_of("time,strain_xx\n2,0.1\n2,0.2\n"), HasSubstr("path.csv:3: the time 2 does not come after 2"));
  EXPECT_THAT(fault_of("strain_xx,strain_yz\n0,0\n"), HasSubstr("path.csv:1: unknown column `strain_yz`"));
  EXPECT_THAT(fault_of("strain_xx\n1 %\n"), HasSubstr("path.csv:2: strain_xx is `1 %`, which is not a number"));
}

TEST(ElementCsv, HoldsEveryNumberToTheBit)
{
  ElementResult result;
  result.columns = {{"time", "s", "time", {0.0, 0.1 + 0.2}}, {"pore_pressure", "Pa", "", {1e5, std::nan("")}}};
  EXPECT_EQ(element_csv(result), "time,pore_pressure\n0,100000\n0.30000000000000004,nan\n");
}

TEST(ElementCase, MaterialsAloneAreACase)
{
  const std::string soil =
      "[material.sand]\nmodel = \"linear_elastic\"\ndensity = 1800.0\nshear_modulus = 4e6\npoisson_ratio = 0.3";
  const CaseFile file = read_element_case_text(soil, "soil.toml", {"material.sand.poisson_ratio=0.2"});
  const auto materials = materials_of_element(file.values, {});
  ASSERT_EQ(materials.size(), 1);
  EXPECT_EQ(materials[0]->parameters[1], 0.2);
  const auto problems = problems_of([&] { materials_of_element(file.values, {"sant"}); });
  ASSERT_EQ(problems.size(), 1);
  EXPECT_THAT(problems[0], told("material", "the case has no material `sant`", testing::HasSubstr("sand")));
}

}  // namespace element_csv_test
