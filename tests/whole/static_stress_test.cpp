// Elastic soil settled under its own weight on distorted meshes, against closed forms. The points lie on a lattice of
// their own, so that cells hold uneven numbers of them. Stress is constant in a cell (MPM-Mixed: its mean), so the
// error is of first order: on a linear stress h / sqrt(12) over the height.
//   column:         sigma_yy = -rho g (H - y), sigma_xx = nu / (1 - nu) sigma_yy
//   infinite slope: as the column with g cos t, and sigma_xy = rho g sin t (H - y), in axes along and across the slope
#include "support/meshes.hpp"
#include "support/paths.hpp"
#include "support/verification.hpp"
#include "run/rest/equilibrium.hpp"
#include <atomic>
#include <iostream>

namespace static_stress_test {

constexpr Real density = 1800.0, g = 9.81, nu = 0.3, shear = 5.0e6;

struct Layer {
  Real width, height, degrees;  // [m], [m], tilt of gravity
  bool fixed_base;
};

void PrintTo(const Layer& layer, std::ostream* out) { *out << layer.width << " m by " << layer.height << " m"; }

constexpr Layer column{2.0, 4.0, 0.0, false}, slope{24.0, 2.0, 20.0, true};

/// A lattice of points of about this spacing [m], as a file of points.
void write_lattice(const std::string& path, const Layer& layer, Real spacing)
{
  std::ofstream file(path);
  file.precision(17);
  file << "x,y,volume,material\n";
  const auto nx = std::lround(layer.width / spacing), ny = std::lround(layer.height / spacing);
  const Real dx = layer.width / static_cast<Real>(nx), dy = layer.height / static_cast<Real>(ny);
  for (long j = 0; j < ny; ++j)
    for (long i = 0; i < nx; ++i)
      file << (static_cast<Real>(i) + 0.5) * dx << ',' << (static_cast<Real>(j) + 0.5) * dy << ',' << dx * dy
           << ",rock\n";
}

Case settling(const Layer& layer, const std::string& scheme, const std::string& points_file)
{
  Case c = free_box(scheme, {0.0, 0.0}, {layer.width, layer.height}, elastic(shear, nu, density));
  c.bodies[0].polygon.clear();
  c.bodies[0].points_file = points_file;
  const Real tilt = layer.degrees * std::numbers::pi / 180.0;
  c.forces.gravity = {g * std::sin(tilt), -g * std::cos(tilt)};
  c.initial.stress = InitialStress::equilibrium;
  c.initial.limit = 5e-4;
  for (const char* name : {"left", "right"}) c.sides.push_back(side(name, SideKind::roller));
  c.sides.push_back(side("bottom", layer.fixed_base ? SideKind::fixed : SideKind::roller));
  return c;
}

/// Root mean square error of normal, horizontal and shear stress over rho g H, at most one height from its middle.
std::array<Real, 3> stress_error(const Layer& layer, const std::string& scheme, Real h)
{
  const ScratchFolder folder;
  const std::string points_file = folder.path() + "/points.csv";
  write_lattice(points_file, layer, h / 8.3);
  const Case c = settling(layer, scheme, points_file);
  const auto n = [h](Real length) { return static_cast<Index>(std::lround(length / h)); };
  Simulation s = simulate_on(distorted_rectangle(n(layer.width), n(layer.height) + 2, h, 0.25, 5), c);
  EXPECT_EQ(find_equilibrium(s.model, s.state, std::atomic<bool>{false}).fault, "");
  std::array<Real, 3> square{};
  Real count = 0.0;
  for (const Point& p : points_by_id(s.state)) {
    const Real x = s.state.x_initial[2 * static_cast<std::size_t>(p.id)],
               y = s.state.x_initial[2 * static_cast<std::size_t>(p.id) + 1];
    if (std::abs(x - 0.5 * layer.width) > layer.height) continue;
    const Real depth = density * (layer.height - y), normal = depth * c.forces.gravity[1];
    square[0] += std::pow(p.sigma[1] - normal, 2);
    square[1] += std::pow(p.sigma[0] - nu / (1.0 - nu) * normal, 2);
    square[2] += std::pow(p.sigma[3] - depth * c.forces.gravity[0], 2);
    count += 1.0;
  }
  for (Real& e : square) e = std::sqrt(e / count) / (density * g * layer.height);
  return square;
}

class StaticStress : public TestWithParam<std::tuple<Layer, std::string>> {};

TEST_P(StaticStress, ErrorIsOfFirstOrderOnDistortedMeshes)
{
  const auto& [layer, scheme] = GetParam();
  const auto coarse = stress_error(layer, scheme, 0.5), fine = stress_error(layer, scheme, 0.25);
  const Real within_a_cell = 0.25 / std::sqrt(12.0) / layer.height;
  for (int k = 0; k < 3; ++k) {
    std::cout << scheme << ": rms error over rho g H, "
              << (k == 0      ? "normal"
                     : k == 1 ? "horizontal"
                              : "shear")
              << ": " << coarse[k] << " at h = 0.5 m, " << fine[k] << " at h = 0.25 m\n";
    EXPECT_LT(fine[k], 1.4 * within_a_cell);
    if (coarse[k] > 0.5 * within_a_cell) {
      EXPECT_GT(coarse[k] / fine[k], 1.7);
    }
  }
}

std::string scheme_name(const testing::TestParamInfo<std::tuple<Layer, std::string>>& p)
{
  return std::get<1>(p.param);
}
INSTANTIATE_TEST_SUITE_P(Column, StaticStress,
    testing::Combine(testing::Values(column), testing::Values("mpm_mixed", "mpm_gp")), scheme_name);
INSTANTIATE_TEST_SUITE_P(InfiniteSlope, StaticStress,
    testing::Combine(testing::Values(slope), testing::Values("mpm_mixed", "mpm_gp")), scheme_name);

}  // namespace static_stress_test
