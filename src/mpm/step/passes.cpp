#include "mpm/step/passes.hpp"

namespace terp {
namespace {

// Shape functions: 8 flops. Interpolating a vector: 14. Rows: as PointRows.
constexpr PassCost mass_and_momentum{.flops = 8 + 20, .rows = 2 + 2 + 1};              // xi v m; corner sums 20
constexpr PassCost acceleration{.flops = 8 + 14 + 2 + 2 + 16, .rows = 2 + 1 + 2 + 2};  // xi m v, v written
constexpr PassCost motion{.flops = 8 + 14 + 2 + 6, .rows = 2 * (2 + 2)};               // x xi, both ways

constexpr PassCost operator+(PassCost a, PassCost b) { return {a.flops + b.flops, a.rows + b.rows}; }

}  // namespace

std::array<PassCost, n_passes> pass_costs(const Scheme& scheme)
{
  return {
#define TERP_PASS(name, title, cost) cost,
#include "mpm/step/passes.def"
#undef TERP_PASS
  };
}

}  // namespace terp
