#include "run/report/slip_planes.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace terp {
namespace {

/// The strength of the point nearest to a place [Pa]; not a number where its soil has none.
Real strength_near(const Model& model, const State& state, const Vec<2>& place)
{
  Real nearest = std::numeric_limits<Real>::infinity(), strength = std::numeric_limits<Real>::quiet_NaN();
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real dx = block.row(Rows::x)[lane] - place[0], dy = block.row(Rows::x + 1)[lane] - place[1];
      const Real square = dx * dx + dy * dy;
      if (square >= nearest) continue;
      nearest = square;
      strength = has_strength(material) ? strength_of(material, block, lane) : std::numeric_limits<Real>::quiet_NaN();
    }
  });
  return strength;
}

}  // namespace

std::string words_of(const SlipPlaneCase& plane)
{
  return plane.name + (plane.method.empty() ? "" : ", " + plane.method) +
         (std::isnan(plane.factor_of_safety) ? "" : fmt::format(", {:.3f}", plane.factor_of_safety));
}

StrengthComparison compare_strength(const Model& model, const State& state, const SlipPlaneCase& plane)
{
  StrengthComparison c{.n_all = plane.su.size()};
  for (const auto& [x, su] : plane.su) {
    const Real ratio = strength_near(model, state, x) * model.description.at_strength / su;
    if (std::isnan(ratio)) continue;
    if (c.n == 0 || ratio < c.low) c.low = ratio, c.x_low = x;
    if (c.n == 0 || ratio > c.high) c.high = ratio, c.x_high = x;
    c.mean = (c.mean * static_cast<Real>(c.n) + ratio) / static_cast<Real>(c.n + 1);
    ++c.n;
  }
  return c;
}

}  // namespace terp
