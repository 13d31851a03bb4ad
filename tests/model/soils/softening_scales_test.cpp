#include "model/soils/softening_scales.hpp"

#include "support/simulations.hpp"

namespace softening_scales_test {

/// The column, 2 m high, on cells of 0.05 m.
std::vector<Problem> with_length(Real length, Real cell = 0.05)
{
  Case c = column("mpm_gp", cell);
  c.materials[0].softening.length = length;
  return warnings_from(find_odd_softening_lengths, c);
}

TEST(SofteningScales, SoilSoftensPointByPointWithoutALengthOrAReferenceWidth)
{
  Case c = column("mpm_gp", 0.5);
  EXPECT_TRUE(softens_point_by_point(build_model(c, 1)));
  c.materials[0].softening.length = 0.6;
  EXPECT_FALSE(softens_point_by_point(build_model(c, 1)));
  c.materials[0].softening.length = 0.0;
  c.materials[0].softening.reference_width = 0.5;
  EXPECT_FALSE(softens_point_by_point(build_model(c, 1)));
  c.materials[0].softening.reference_width = 0.0;
  const MaterialType& law = *find_material("tresca_softening");
  const auto of = [&](std::string_view name) -> Real& {
    const auto found = std::ranges::find(law.parameters, name, &ParameterInfo::name);
    return c.materials[0].parameters[static_cast<std::size_t>(found - law.parameters.begin())];
  };
  of("su_residual") = of("su_peak");  // its strength stays
  EXPECT_FALSE(softens_point_by_point(build_model(c, 1)));
}

TEST(SofteningScales, AreSilentBetweenTwoCellsAndATwentiethOfTheHeight) { EXPECT_THAT(with_length(0.1), IsEmpty()); }

TEST(SofteningScales, ALengthOfLessThanTwoCellsIsDoubted)
{
  EXPECT_THAT(with_length(0.08),
      ElementsAre(told("material.\"clay\".softening.length", "the softening length holds less than two cells",
          "Got 0.08 m for `clay`; cells with this soil are up to 0.05 m wide. A slip surface takes up to 14 % more "
          "energy than on "
          "fine cells.\nUsual: at least 0.1 m, or cells of at most 0.04 m.")));
}

TEST(SofteningScales, ALengthThatIsLongBesideTheSectionIsDoubted)
{
  EXPECT_THAT(with_length(0.2),
      ElementsAre(told("material.\"clay\".softening.length",
          "`clay`: soil within 0.4 m of a slip surface softens, too, as the length of 0.2 m is more than H/20; give "
          "0.0995 m on cells of at most 0.0498 m (docs/softening_length.md)",
          "")));
}

TEST(SofteningScales, ALengthThatSuitsNeitherCellsNorSectionIsToldOnceForAllSoils)
{
  Case c = column("mpm_gp", 0.25);
  c.materials[0].softening.length = 0.3;
  c.materials.push_back(c.materials[0]);
  c.materials[1].name = "peat";
  c.bodies = {body("clay", {0.0, 0.0}, {8.0, 1.0}), body("peat", {0.0, 1.0}, {8.0, 2.0})};
  EXPECT_THAT(warnings_from(find_odd_softening_lengths, c),
      ElementsAre(told("material.\"clay\".softening.length",
          "the cells are too large for a softening length that suits the section",
          "Got 0.3 m for `clay`, `peat`; cells with this soil are up to 0.25 m wide, the soil is H = "
          "1.95 m high.\nA slip surface takes up to 14 % more energy than on fine cells, and soil within about 2 l "
          "of it softens, too.\n"
          "Usual: 0.0975 m (H/20) on cells of at most 0.04875 m.")));
}

TEST(SofteningScales, TheLongSidesOfCellsCount)  // their area is that of squares of 0.05 m
{
  Case c = column("mpm_gp", 0.05);
  c.materials[0].softening.length = 0.1;
  c.mesh.cell = {0.1, 0.025};
  EXPECT_THAT(warnings_from(find_odd_softening_lengths, c),
      ElementsAre(told("material.\"clay\".softening.length", "the softening length holds less than two cells",
          HasSubstr("cells with this soil are up to 0.1 m wide."))));
  c.mesh.cell = {0.025, 0.1};
  EXPECT_EQ(warnings_from(find_odd_softening_lengths, c).size(), 1u);
}

TEST(SofteningScales, ALengthShorterThanACellIsRefused)
{
  EXPECT_THAT(problems_of([] { with_length(0.04); }),
      ElementsAre(told("material.\"clay\".softening.length", "the softening length is shorter than a cell",
          "Got 0.04 m; cells with this soil measure up to 0.05 m (square root of the area): nothing would spread.\n"
          "Allowed: at least 0.05 m, better 0.1 m or more. Give that, or smaller cells.")));
}

TEST(SofteningScales, ALengthOfMoreThanAHundredCellsIsRefused)  // 200 mm written as 200
{
  Case c = column("mpm_gp", 0.5);
  c.materials[0].softening.length = 200.0;
  EXPECT_THAT(problems_of([&] { build_model(c, 1); }),
      ElementsAre(told("material.\"clay\".softening.length", "the softening length spans too many cells",
          "Got 200 m; the smallest cell is 0.5 m high. Allowed: at most 100 of them, 50 m.\nLengths are in m.")));
}

}  // namespace softening_scales_test
