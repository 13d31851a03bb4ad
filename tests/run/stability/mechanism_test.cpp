#include "run/stability/mechanism.hpp"
#include "run/loop/simulation.hpp"
#include "support/cases.hpp"

namespace mechanism_test {

/// A bank 8 m wide whose right half is 2 m high and whose left half is 4 m high, cells of 0.5 m.
Case bank(bool mirrored = false)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {8.0, 2.0});
  c.mesh.size = {8.0, 5.0};
  c.mesh.cell = {0.5, 0.5};
  c.bodies[0].points_per_cell = {4, 4};
  c.bodies.push_back(body("clay", {mirrored ? 4.0 : 0.0, 2.0}, {mirrored ? 8.0 : 4.0, 4.0}));
  c.bodies[1].points_per_cell = {4, 4};
  return c;
}

/// The points before and after those moved by dx(place at rest).
struct Moved {
  Simulation s;
  PointMotion before, now;
  Moved(const Case& c, const std::function<Vec<2>(Vec<2>)>& dx) : s(c), before(look_at_points(s.state)), now(before)
  {
    for (std::size_t k = 0; k < now.x.size(); k += 2) {
      const Vec<2> d = dx({s.state.x_initial[k], s.state.x_initial[k + 1]});
      now.x[k] += d[0], now.x[k + 1] += d[1];
      now.strain[2 * k + 3] += d[0];  // xy
    }
  }
  Mechanism mechanism(Real stiffening = 1.0, const Judged& judged = {}) const
  {
    return find_mechanism(s.model, s.state, before, now, judged, stiffening);
  }
};

/// A block above the line from (2, 4) to (5, 1), which comes out at x = 6, moves down and out.
Vec<2> slides(Vec<2> x)
{
  const bool moves = x[0] > 2.0 && x[0] < 6.0 && x[1] > std::max(6.0 - x[0], 1.0);
  return moves ? Vec<2>{1e-3, -5e-4} : Vec<2>{0.0, 0.0};
}

TEST(Mechanism, NamesTheSoilWithoutCohesionThatMostOfItIsOf)
{
  Case c = bank();
  EXPECT_EQ(Moved(c, slides).mechanism().moving->sand, "");
  c.materials[0] = {"clay", "mohr_coulomb", 1990.0, {2e6, 0.3, 0.0, 30.0, 0.0}};
  c.materials[0].parameters.resize(find_material("mohr_coulomb")->parameters.size(), 0.0);
  EXPECT_EQ(Moved(c, slides).mechanism().moving->sand, "clay");
  c.materials[0].parameters[2] = 1e3;
  EXPECT_EQ(Moved(c, slides).mechanism().moving->sand, "");
}

TEST(Mechanism, IsThePartThatMovesWithItsLineItsWayAndItsSize)
{
  const auto moving = Moved(bank(), slides).mechanism().moving;
  ASSERT_TRUE(moving.has_value());
  EXPECT_EQ(moving->way, Facing::right);
  EXPECT_EQ(moving->slope, Facing::right);
  EXPECT_NEAR(moving->highest_x, 2.0, 1e-9);
  EXPECT_EQ(moving->entry[0], 2.0);
  EXPECT_NEAR(moving->entry[1], 3.94, 0.01);  // the highest points
  EXPECT_EQ(moving->exit[0], 6.0);
  ASSERT_EQ(moving->line.size(), 10u);
  for (const Vec<2>& x : moving->line) {
    if (x[0] == 2.0 || x[0] == 6.0) continue;
    EXPECT_NEAR(x[1], std::max(6.0 - x[0], 1.0), 0.2) << x[0];  // points are 0.125 m apart
  }
  EXPECT_NEAR(moving->depth, 3.94 - 2.25, 0.2);
  // above the line: 2 m^2 to x = 4 and, to 2 m of height, 1/2 + 1 m^2 beyond
  EXPECT_NEAR(moving->area, 3.5, 0.2);
  EXPECT_EQ(moving->other_way, 0.0);
}

TEST(Mechanism, MirroredItFailsToTheLeft)
{
  const auto moving = Moved(bank(true),
      [](Vec<2> x) {
        const Vec<2> d = slides({8.0 - x[0], x[1]});
        return Vec<2>{-d[0], d[1]};
      })
                          .mechanism()
                          .moving;
  ASSERT_TRUE(moving.has_value());
  EXPECT_EQ(moving->way, Facing::left);
  EXPECT_EQ(moving->slope, Facing::left);
  EXPECT_EQ(moving->entry[0], 6.0);
  EXPECT_EQ(moving->exit[0], 2.0);
}

TEST(Mechanism, OfTwoPartsTheOneThatMovesMost)
{
  const auto moving = Moved(bank(),
      [](Vec<2> x) {
        return x[0] < 1.0 && x[1] > 3.0 ? Vec<2>{-1e-3, 0.0} : slides(x);
      })
                          .mechanism()
                          .moving;
  ASSERT_TRUE(moving.has_value());
  EXPECT_EQ(moving->way, Facing::right);
  EXPECT_EQ(moving->entry[0], 2.0);
  EXPECT_NEAR(moving->other_way, 1.0 / 4.5, 0.03);
}

TEST(Mechanism, FieldsAreThoseOfTheSoilBeforeItWasStiffened)
{
  const Moved moved(bank(), slides);
  const Frame frame = moved.mechanism(100.0).frame;
  const auto field = [&](std::string_view name) { return *std::ranges::find(frame.fields, name, &PointField::name); };
  const std::vector<Real> shear = field("shear_increment").values;
  const auto k = static_cast<std::size_t>(std::ranges::max_element(shear) - shear.begin());
  EXPECT_NEAR(field("displacement_increment").values[3 * k], 0.1, 1e-12);
  EXPECT_NEAR(shear[k], 0.1, 1e-12);  // sqrt(1/2 e:e) of xy = yx = 0.1
  EXPECT_EQ(frame.x, moved.s.state.x_initial);
  EXPECT_EQ(field("stress").n_components, 4);
}

TEST(Mechanism, SoilThatIsNotJudgedStillShapesIt)  // a skin of 0.5 m slides, and drags a little of what is below
{
  const Moved moved(bank(), [](Vec<2> x) {
    if (x[0] > 4.0) return Vec<2>{0.0, 0.0};
    if (x[1] > 3.5) return Vec<2>{1e-2, 0.0};
    if (x[0] < 1.0) return Vec<2>{x[1] > 3.0 ? 1e-3 : 0.0, 0.0};
    return Vec<2>{x[1] > 1.0 ? 2e-4 : 0.0, 0.0};  // to a depth of 3 m, less than half of what moves most
  });
  const Judged judged = points_below(moved.s.model, moved.s.state, 0.5);
  const auto moving = moved.mechanism(1.0, judged).moving;
  ASSERT_TRUE(moving.has_value());
  EXPECT_NEAR(moving->depth, 0.94, 0.1);
}

TEST(Mechanism, OfSoilAtRestIsNone)
{
  EXPECT_FALSE(Moved(bank(), [](Vec<2>) { return Vec<2>{0.0, 0.0}; }).mechanism().moving.has_value());
}

}  // namespace mechanism_test
