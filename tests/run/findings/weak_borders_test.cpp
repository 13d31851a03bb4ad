#include "run/findings/weak_borders.hpp"
#include "model/parts/setup.hpp"
#include "run/findings/setup_warnings.hpp"
#include "support/aquifer.hpp"

#include <numbers>

namespace weak_borders_test {

std::vector<WeakBorder> borders_of(const Case& c, Real row = 1.0)
{
  const Model model = build_model(c, 1);
  return find_weak_borders(model, c.water.start, row);
}

const Real tangent = std::tan(std::numbers::pi / 6.0);

TEST(WeakBorders, CarryWhatARowHasOverItsTop)
{
  // 48 kPa of clay on the sand: a head of 9.8 m leaves nothing of it, one of 9 m 8 kPa
  for (const Real right : {9.8, 9.0}) {
    const auto found = borders_of(cover(9.8, right));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].material, 1);
    EXPECT_NEAR(found[0].from(), 0.0, 1e-9);
    EXPECT_NEAR(found[0].to(), 40.0, 1e-9);
    const Real stress = 48e3 - 10e3 * (right - 5.0);
    EXPECT_NEAR(found[0].places.back().stress, stress, 1e-3);
    // by hand: what the row of 1 m carries in its middle, less what it carries at its top
    const Real lifted = 20.0 * tangent * 10e3 * 0.5,
               other = 20.0 * (tangent * (stress + 10e3 * 0.5) - tangent * stress);
    EXPECT_NEAR(found[0].carried_more(1.0), lifted + other, 1e-3);
    EXPECT_NEAR(found[0].carried_more(0.1), 0.1 * lifted + (stress < 5e3 ? 0.1 * other : 0.0), 1e-3);
  }
}

TEST(WeakBorders, AreWhereWaterPushesFromBelowAndTheTopIsWeak)
{
  const auto half = borders_of(cover(9.8, 8.0));  // 18 kPa on the right, less than 50
  ASSERT_EQ(half.size(), 1u);
  EXPECT_NEAR(half[0].to(), 40.0, 1e-9);
  EXPECT_NEAR(borders_of(cover(9.8, 8.0), 0.3).at(0).to(), 20.0, 1e-9) << "18 kPa are more than five rows of 0.3 m";
  EXPECT_TRUE(borders_of(cover(8.0, 8.0)).empty()) << "that of the phreatic line";
  EXPECT_TRUE(borders_of(cover(9.8, 9.8, sand(30.0, 2e3))).empty());
}

TEST(WeakBorders, AFilmIsMeant)
{
  MaterialCase film = sand(30.0);
  const auto& parameters = film.type()->parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (parameters[k].name.starts_with("friction_angle"))
      film.fields.push_back({k, [](const PlaceInSoil&) { return 5.0; }});
  EXPECT_TRUE(borders_of(cover(9.8, 9.8, film)).empty());
}

TEST(WeakBorders, AreWarnedOfWithTheCellsThatSeeThem)
{
  Case c = cover(9.8, 8.0);
  const auto warning_of = [](const Case& of) {
    Model model = build_model(of, 1);
    const State state = build_state(model);
    for (const Problem& problem : find_warnings(model, state))
      if (problem.what.find("a row of cells carries") != std::string::npos) return problem.what + " " + problem.detail;
    return std::string();
  };
  const std::string text = warning_of(c);
  EXPECT_NE(text.find("carries 115 kN/m more than the top of `sand`, x = 0 to 40 m"), std::string::npos) << text;
  EXPECT_NE(text.find("cells of 0.17 m, which carry 10 kN/m more"), std::string::npos) << text;
  c.water.situations = {c.water.start};
  c.water.situations[0].name = "flood";
  c.water.start.head_lines[0].places = {{0.0, 8.0}};
  EXPECT_EQ(warning_of(c), "") << "nothing asks for it";
  c.water.situations[0].time = 0.5;
  EXPECT_NE(warning_of(c), "");
}

}  // namespace weak_borders_test
