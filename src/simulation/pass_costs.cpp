#include "simulation/pass_costs.hpp"

namespace terp {
namespace {

constexpr double row = sizeof(Real);

// Rows that a pass reads and writes. Shape functions: 8 flops. Interpolating a vector: 14.
constexpr PassCost gather_at_gauss{
    8 + 20 + 4 + 32, (2 + 2 + 1 + 1 + 4) * row};  // xi v m Omega sigma; corner sums 20, sub-cell sums 36
constexpr PassCost gather_mixed{8 + 20 + 4 + 40, (2 + 2 + 1 + 1 + 4 + 1) * row};       // and one state variable
constexpr PassCost gather_at_points{8 + 20 + 3 + 44 + 28, (2 + 2 + 1 + 1 + 4) * row};  // gradients 44, force 28
constexpr PassCost scatter{8 + 14 + 2 + 2 + 16, (2 + 1 + 2 + 2) * row};                // xi m v, v written
constexpr double motion = 8 + 14 + 2 + 6;  // new place and local coordinates
constexpr PassCost stress_gp{
    6 + 20 + 30 + 9 + motion, 2 * (2 + 2 + 4 + 4 + 1 + 1) * row};  // xi x sigma strain Omega state, both ways
constexpr PassCost stress_mixed{
    9 + motion, (2 + 2 + 4 + 1) * row + (2 + 2 + 4 + 4 + 1 + 1) * row};  // sigma and state only written
constexpr PassCost stress_standard{44 + 28 + 20 + 30 + 9 + motion, 2 * (2 + 2 + 4 + 4 + 1 + 1) * row};

}  // namespace

std::array<PassCost, n_passes> pass_costs(std::string_view scheme)
{
  std::array<PassCost, n_passes> costs{};
  const bool mixed = scheme == "mpm_mixed", standard = scheme == "standard_mpm";
  costs[points_to_cells] = standard ? gather_at_points : mixed ? gather_mixed : gather_at_gauss;
  costs[cells_to_points] = scatter;
  costs[stress] = standard ? stress_standard : mixed ? stress_mixed : stress_gp;
  return costs;
}

}  // namespace terp
