#include "run/stability/mesh_error.hpp"

#include "math/convergence.hpp"
#include "math/errors.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

namespace {

Real end_of(const SizedFactor& size)
{
  return std::isnan(size.highest) ? size.factor + size.uncertainty : size.highest;
}

}  // namespace

FactorLimit extrapolate_factor(std::vector<SizedFactor> sizes)
{
  TERP_ASSERT(sizes.size() >= 2);
  std::ranges::sort(sizes, {}, &SizedFactor::cell);
  const SizedFactor &fine = sizes[0], &coarse = sizes[1];
  FactorLimit limit;
  limit.order = usual_order;
  Real low_order = lowest_order, high_order = highest_order;
  if (sizes.size() >= 3) {
    std::vector<Real> cells, factors;
    for (const SizedFactor& size : sizes) cells.push_back(size.cell), factors.push_back(size.factor);
    if (const RefinementEstimate found = estimate_limit(cells, factors); found.order_is_usable()) {
      limit.order = limit.order_found = found.order;
      limit.order_is_observed = true;
      low_order = std::min(low_order, found.order);
      high_order = std::max(high_order, found.order);
    } else {
      limit.order_found = found.order;
    }
  }
  if (!(fine.factor < coarse.factor)) {
    limit.is_extrapolated = false;
    limit.factor = std::min(fine.factor, coarse.factor);
    limit.low = std::min(fine.factor - fine.uncertainty, coarse.factor - coarse.uncertainty);
    limit.high = std::min(end_of(fine), end_of(coarse));
    return limit;
  }
  const Real ratio = coarse.cell / fine.cell;
  const auto steps = [&](Real order) { return 1.0 / (std::pow(ratio, order) - 1.0); };  // of the last one, to come
  const Real step = fine.factor - coarse.factor, most = steps(low_order), least = steps(high_order);
  const Real noise = fine.uncertainty + most * (fine.uncertainty + coarse.uncertainty);
  limit.factor = fine.factor + step * steps(limit.order);
  limit.low = std::min(fine.factor + step * most, fine.factor + step * least) - noise;
  limit.high = std::min(end_of(fine), std::max(fine.factor + step * most, fine.factor + step * least) + noise);
  return limit;
}

/// Slopes of other authors and known limits: docs/stability.md. Above all of them, steep cuts with friction.
Real largest_mesh_error(Real cells_over_depth) { return 1.35 / cells_over_depth; }

}  // namespace terp
