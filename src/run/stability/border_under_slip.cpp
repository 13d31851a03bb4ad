#include "run/stability/border_under_slip.hpp"

#include "model/meshes/setup_mesh.hpp"
#include "model/water/water_pressure.hpp"
#include "mpm/points/soil_material.hpp"
#include "math/interpolate.hpp"
#include "run/findings/weak_borders.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real below = 1.01, above = 0.5;  // rows between a border and a slip surface that follows it

/// Sum of the shear stress along a line times its length [N per m]: of each side the mean of the points within half a
/// row of its middle.
Real shear_along(const State& state, const std::vector<Vec<2>>& line, Real row)
{
  struct Sum {
    Real volume = 0.0, shear = 0.0;
  };
  std::vector<Sum> sides(line.size() - 1);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Vec<2> x{state.x_initial[2 * id], state.x_initial[2 * id + 1]};
    const auto after = std::ranges::upper_bound(line, x[0], {}, [](const Vec<2>& at) { return at[0]; });
    if (after == line.begin() || after == line.end()) return;
    const Vec<2>&a = *(after - 1), &b = *after;
    const Real slope = (b[1] - a[1]) / (b[0] - a[0]), z = a[1] + slope * (x[0] - a[0]);
    if (std::abs(x[1] - z) > 0.5 * row * std::hypot(1.0, slope)) return;
    const SymTensor<Real, 2> sigma = stress_at(block, lane);
    const Real shear = (slope * (sigma[1] - sigma[0]) + (1.0 - slope * slope) * sigma[3]) / (1.0 + slope * slope);
    Sum& sum = sides[static_cast<std::size_t>(after - line.begin() - 1)];
    const Real volume = block.row(Rows::volume)[lane];
    sum.volume += volume, sum.shear += volume * shear;
  });
  Real all = 0.0;
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (sides[k].volume > 0.0)
      all += std::abs(sides[k].shear / sides[k].volume) *
             std::hypot(line[k + 1][0] - line[k][0], line[k + 1][1] - line[k][1]);
  return all;
}

}  // namespace

std::optional<BorderUnderSlip> find_border_under(
    const Model& model, const State& state, const std::vector<Vec<2>>& line)
{
  const WaterCase& water = model.description.water;
  if (!water.is_given() || line.size() < 2) return std::nullopt;
  const Real row = typical_cell_size(*model.mesh);
  std::optional<BorderUnderSlip> most;
  for (const WeakBorder& border : find_weak_borders(model, first_water(water), row)) {
    BorderUnderSlip under{model.materials[border.material].name, INFINITY, -INFINITY, row, 0.0, 0.0};
    for (const BorderPlace& place : border.places) {
      const Real x = place.x[0];
      if (x < line.front()[0] || x > line.back()[0]) continue;
      const Real over = interpolate(line, x) - place.x[1];
      if (over < -below * row || over > above * row) continue;
      under.from = std::min(under.from, x - 0.5 * border.width);
      under.to = std::max(under.to, x + 0.5 * border.width);
      under.carried_more += border.width * place.carried_more(row);
    }
    if (under.carried_more > (most ? most->carried_more : 0.0)) most = under;
  }
  if (most) most->strength = shear_along(state, line, row);
  return most && most->carried_more < most->strength ? most : std::nullopt;
}

}  // namespace terp
