// The stress of a turning body turns with it under the Jaumann rate, and stays without it (reading R17).
#include "support/simulations.hpp"

namespace objective_rate_test {

constexpr Real spin = 10.0;  // counter-clockwise [rad/s]
constexpr Real dt = 1e-6;    // so short that the stress does not yet strain the body [s]
constexpr Real sigma_xx = -0.5, sigma_yy = 1.5, sigma_xy = 0.75;  // [Pa]

/// A box under one stress that turns about its middle, after one step.
std::vector<Point> turn(const char* scheme, ObjectiveRate rate)
{
  Case c = free_box(scheme, {1.0, 0.5}, {2.0, 1.5}, elastic(2e6, 0.3, 2000.0));
  c.method.objective_rate = rate;
  Model model = build_model(c, 1);
  model.dt = dt;
  State state = build_state(model);
  edit_points(state, [](const PointBlock<2>& block, Index lane) {
    block.row(Rows::v)[lane] = -spin * (block.row(Rows::x + 1)[lane] - 1.0);
    block.row(Rows::v + 1)[lane] = spin * (block.row(Rows::x)[lane] - 1.5);
    block.row(Rows::sigma)[lane] = sigma_xx;
    block.row(Rows::sigma + 1)[lane] = sigma_yy;
    block.row(Rows::sigma + 3)[lane] = sigma_xy;
  });
  Simulation s(std::move(model), std::move(state));
  s.step();
  return points_by_id(s.state);
}

/// Points whose cell has no free surface: there the velocity at the nodes is the rigid one.
bool is_inside(const Point& p) { return std::abs(p.x[0] - 1.5) < 0.25 && std::abs(p.x[1] - 1.0) < 0.25; }

TEST(ObjectiveRate, JaumannTurnsTheStressWithTheBody)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"})
    for (const Point& p : turn(scheme, ObjectiveRate::jaumann)) {
      if (!is_inside(p)) continue;
      const Real angle = spin * dt;  // d_sigma = W sigma - sigma W
      EXPECT_NEAR((p.sigma[0] - sigma_xx) / angle, -2.0 * sigma_xy, 0.02) << scheme;
      EXPECT_NEAR((p.sigma[1] - sigma_yy) / angle, 2.0 * sigma_xy, 0.02) << scheme;
      EXPECT_NEAR((p.sigma[3] - sigma_xy) / angle, sigma_xx - sigma_yy, 0.02) << scheme;
    }
}

TEST(ObjectiveRate, NoneLeavesTheStressWhereItWas)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"})
    for (const Point& p : turn(scheme, ObjectiveRate::none)) {
      if (!is_inside(p)) continue;
      EXPECT_NEAR(p.sigma[0], sigma_xx, 0.02 * spin * dt) << scheme;
      EXPECT_NEAR(p.sigma[3], sigma_xy, 0.02 * spin * dt) << scheme;
    }
}

}  // namespace objective_rate_test
