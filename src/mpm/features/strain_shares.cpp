#include "mpm/features/strain_shares.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {
namespace {

/// Of schemes that integrate at Gauss points.
void fit_strain_shares(const StepModel& model, const StepState& state, Workspace& work)
{
  const bool transposed = model.method.strain_shares == StrainShares::transposed;
  if (!transposed || !looks_at(*model.scheme, "strain_shares")) return work.with.strain_shares.clear();
  fit_array(static_cast<std::size_t>(state.points.n_blocks()), work.with.strain_shares.made().ratios);
}

}  // namespace

TERP_FEATURE_DEFINITION(strain_shares, .fit = &fit_strain_shares)

}  // namespace terp
