// An elastic bar that vibrates along its axis between fixed ends: v = V sin(pi x / L) cos(omega t), omega = pi c_p / L.
// Error of the velocity after a period against h, distorted meshes; rectangular: cases/verification/vibrating_bar.
#include "support/meshes.hpp"
#include "support/verification.hpp"
#include <iostream>

namespace vibrating_bar_test {

constexpr Real length = 4.0, amplitude = 1.0e-4;  // [m], [m/s]: displacements stay far below a cell

/// Largest error of the axial velocity after one period, over the amplitude.
Real error_after_a_period(const std::string& scheme, Real h, Real distortion)
{
  Case c = free_box(scheme, {0.0, 0.0}, {length, 4.0 * h}, elastic(4.0e6, 0.25, 2000.0));
  c.time.courant = 0.2;
  for (const char* name : {"left", "right", "bottom", "top"}) c.sides.push_back(side(name, SideKind::roller));
  Simulation s = simulate_on(distorted_rectangle(static_cast<Index>(std::lround(length / h)), 4, h, distortion, 3), c);
  const Material& law = *s.model.materials[0].law;
  const Real speed = std::sqrt(law.p_wave_modulus() / 2000.0), period = 2.0 * length / speed,
             wave = std::numbers::pi / length;
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    block.row(Rows::v)[lane] = amplitude * std::sin(wave * block.row(Rows::x)[lane]);
  });
  s.step(std::llround(period / s.model.dt));
  Real square = 0.0;
  const auto points = points_by_id(s.state);
  for (const Point& p : points)
    square += std::pow(p.v[0] / amplitude - std::sin(wave * p.x[0]) * std::cos(wave * speed * s.state.time), 2);
  return std::sqrt(square / static_cast<Real>(points.size()));
}

class VibratingBar : public TestWithParam<std::string> {};

TEST_P(VibratingBar, ErrorFallsWithTheCellSize)
{
  constexpr Real distortion = 0.2;
  const std::array<Real, 3> sizes{0.5, 0.25, 0.125};
  std::array<Real, 3> error;
  for (int k = 0; k < 3; ++k) error[k] = error_after_a_period(GetParam(), sizes[k], distortion);
  const Real order = std::log2(error[0] / error[2]) / 2.0;
  std::cout << GetParam() << ": rms error " << error[0] << ' ' << error[1] << ' ' << error[2] << ", order " << order
            << '\n';
  EXPECT_GT(order, 0.9);
  EXPECT_LT(error[2], 0.15);
}

INSTANTIATE_TEST_SUITE_P(Schemes, VibratingBar, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"),
    [](const auto& p) { return p.param; });

}  // namespace vibrating_bar_test
