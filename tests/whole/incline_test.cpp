// A stiff block on an inclined mesh: a = g (sin t - mu cos t) - a L / m along the slope, and rest where friction
// suffices. It is flat, so that it does not rock. Its base nodes are close: adhesion counts half an edge too much at
// each end. The contact is separating: on a bilateral one only pushes cause friction (decision 0015).
#include "support/verification.hpp"

namespace incline_test {

constexpr Real g = 9.81;           // [m/s^2]
constexpr Real density = 2000.0;   // [kg/m^3]
constexpr Vec<2> block{4.0, 0.5};  // length along the slope and height [m]

struct Slope {
  Real degrees, friction, adhesion;  // [-], [Pa]
};

Real radians(Real degrees) { return degrees * std::numbers::pi / 180.0; }

/// The block at rest near the upper end of a slope that falls to the right.
Simulation block_on(const Slope& slope, const std::string& scheme, SideKind kind)
{
  Case c = free_box(scheme, {0.5, 0.0}, {0.5 + block[0], block[1]}, elastic(2.0e7, 0.3, density));
  c.bodies[0].points_per_cell = {3, 3};
  c.method.shares = Shares::point;  // the contact is tested: the block chatters by 1 % more or less with either shares
  c.sides = {side("bottom", kind)};
  c.sides[0].friction = slope.friction;
  c.sides[0].adhesion = slope.adhesion;
  const Real angle = -radians(slope.degrees);
  for (BodyCase& b : c.bodies)
    for (Vec<2>& x : b.polygon) x = turned(x, angle);
  c.forces.gravity = {0.0, -g};
  return simulate_on(turned(make_rectangle({0.0, 0.0}, {8.0, 1.0}, {160, 4}), angle), c);
}

/// The stress across the slope that carries the block's weight, from the start.
void carry_weight(State& state, const Slope& slope)
{
  const Real angle = -radians(slope.degrees);
  edit_points(state, [&](const PointBlock<2>& b, Index lane) {
    const Vec<2> x = turned({b.row(Rows::x)[lane], b.row(Rows::x + 1)[lane]}, -angle);
    const Real n = -density * g * std::cos(angle) * (block[1] - x[1]);
    b.row(Rows::sigma)[lane] = n * std::sin(angle) * std::sin(angle);
    b.row(Rows::sigma + 1)[lane] = n * std::cos(angle) * std::cos(angle);
    b.row(Rows::sigma + 3)[lane] = -n * std::sin(angle) * std::cos(angle);
  });
}

Real along(Vec<2> v, Real degrees) { return v[0] * std::cos(radians(degrees)) - v[1] * std::sin(radians(degrees)); }

Real expected_acceleration(const Slope& s)
{
  const Real mass = density * block[0] * block[1];
  return g * (std::sin(radians(s.degrees)) - s.friction * std::cos(radians(s.degrees))) - s.adhesion * block[0] / mass;
}

/// Mean acceleration along the slope over 0.2 s.
Real acceleration(const Slope& slope, const std::string& scheme, SideKind kind)
{
  Simulation s = block_on(slope, scheme, kind);
  carry_weight(s.state, slope);
  s.step(static_cast<std::int64_t>(0.2 / s.model.dt));
  return along(mean_velocity(s.state), slope.degrees) / s.state.time;
}

class Incline : public TestWithParam<std::string> {};

TEST_P(Incline, BlockAcceleratesByGravityLessFrictionAndAdhesion)
{
  const Real within = GetParam() == "standard_mpm" ? 0.015 : 0.01;
  for (const Slope slope :
      {Slope{15.0, 0.1, 0.0}, {30.0, 0.3, 0.0}, {45.0, 0.5, 0.0}, {30.0, 0.0, 1.0e3}, {45.0, 0.2, 1.0e3}}) {
    const Real expected = expected_acceleration(slope);
    EXPECT_NEAR(acceleration(slope, GetParam(), SideKind::contact_separating), expected, within * expected)
        << slope.degrees << " degrees, friction " << slope.friction << ", adhesion " << slope.adhesion;
  }
}

TEST_P(Incline, AdhesionSlowsABlockOnABilateralBase)
{
  for (const Slope slope : {Slope{15.0, 0.0, 5.0e2}, {30.0, 0.0, 1.0e3}, {45.0, 0.0, 2.0e3}}) {
    const Real expected = expected_acceleration(slope);
    EXPECT_NEAR(acceleration(slope, GetParam(), SideKind::contact_bilateral), expected, 0.01 * expected)
        << slope.degrees << " degrees, adhesion " << slope.adhesion;
  }
}

TEST_P(Incline, BlockSticksWhereTheSlopeIsTooGentle)
{
  for (const SideKind kind : {SideKind::contact_bilateral, SideKind::contact_separating})
    for (const Slope slope : {Slope{15.0, 0.35, 0.0}, {30.0, 0.7, 0.0}, {30.0, 0.0, 1.0e4}}) {
      ASSERT_LT(expected_acceleration(slope), 0.0);
      EXPECT_NEAR(acceleration(slope, GetParam(), kind), 0.0, 0.01 * g)
          << slope.degrees << " degrees, friction " << slope.friction << ", adhesion " << slope.adhesion;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, Incline, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"), [](const auto& p) { return p.param; });

}  // namespace incline_test
