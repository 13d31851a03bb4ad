// Mesh, soil and gravity turned together by 30 degrees: the same failure in another frame.
#include "support/verification.hpp"

namespace frame_test {

constexpr Real angle = std::numbers::pi / 6.0;

Simulation column_in_frame(const std::string& scheme, Real cell, Real turn)
{
  Case c = column(scheme, cell);
  const Mesh<2> mesh = make_rectangle(c.mesh.origin, c.mesh.size,
      {static_cast<Index>(std::lround(c.mesh.size[0] / cell)), static_cast<Index>(std::lround(c.mesh.size[1] / cell))});
  for (Vec<2>& x : c.bodies[0].polygon) x = turned(x, turn);
  c.forces.gravity = turned(c.forces.gravity, turn);
  c.forces.local_damping = 0.0;  // sign(v) of a velocity that is round-off: differences of 1e-8 m by 0.1 s
  return simulate_on(turn == 0.0 ? mesh : turned(mesh, turn), c);
}

class Frame30 : public TestWithParam<std::string> {};

TEST_P(Frame30, ColumnFailsTheSameWayInATurnedFrame)
{
  Simulation straight = column_in_frame(GetParam(), 0.2, 0.0), turned = column_in_frame(GetParam(), 0.2, angle);
  const auto n = static_cast<std::int64_t>(0.65 / straight.model.dt);
  straight.step(n);
  turned.step(n);
  const auto a = points_by_id(straight.state), b = points_by_id(turned.state);
  ASSERT_EQ(a.size(), b.size());
  Real place = 0.0, strain = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Vec<2> back = test::turned(b[k].x, -angle);
    place = std::max(place, std::hypot(back[0] - a[k].x[0], back[1] - a[k].x[1]));
    strain = std::max(strain, std::abs(a[k].eps_eq_p() - b[k].eps_eq_p()));
    largest = std::max(largest, a[k].eps_eq_p());
  }
  EXPECT_GT(largest, 0.5);  // it has failed
  RecordProperty("place", std::to_string(place));
  EXPECT_LT(place, 1e-6)
      << "m; round-off that the failure amplifies: 5e-10 m here, 1 cm at 0.8 s, when single points run ahead";
  EXPECT_LT(strain, 1e-5 * largest);
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, Frame30, testing::Values("mpm_mixed", "mpm_gp"), [](const auto& p) { return p.param; });

}  // namespace frame_test
