#include "mpm/step/kept_soil.hpp"

#include "math/pack.hpp"
#include "mpm/features/excess.hpp"
#include "mpm/features/slip.hpp"
#include "mpm/features/strain_shares.hpp"
#include "mpm/features/volume_change.hpp"
#include "mpm/schemes/scheme.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>

namespace terp {

struct KeptSoil::Kept {
  std::vector<Real> points, pressure, excess;
  std::vector<BlockSlip> slips;
  std::vector<PerGauss<Quad4>> ratios;
  std::vector<VolumeGradient<Quad4>> volume_gradients;
  std::vector<GaussValues<Quad4, Pack>> gauss;  // of schemes that change them in their update
  std::vector<GaussRow<Quad4>> gauss_rows;
};

namespace {

std::ptrdiff_t n_values(const PointBlocks<2>& points, const PointBlock<2>& block)
{
  return static_cast<std::ptrdiff_t>(points.n_rows()) * block.capacity;
}

}  // namespace

KeptSoil::KeptSoil() : kept_(std::make_unique<Kept>()) {}
KeptSoil::~KeptSoil() = default;

void KeptSoil::keep(const StepModel& model, const StepState& state, const Workspace& work)
{
  Kept& kept = *kept_;
  kept.points.clear();
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    kept.points.insert(kept.points.end(), block.data, block.data + n_values(state.points, block));
  });
  kept.pressure = work.pressure;
  if (work.with.excess) kept.excess = work.with.excess->pressure;
  if (work.with.slip) kept.slips = work.with.slip->blocks;
  if (work.with.strain_shares) kept.ratios = work.with.strain_shares->ratios;
  if (const auto& volume = work.with.volume_change)
    kept.volume_gradients.assign(volume->gradients.begin(), volume->gradients.end());
  if (!model.scheme->keeps_gauss_values) return;
  kept.gauss.assign(work.gauss.begin(), work.gauss.end());
  kept.gauss_rows.assign(work.gauss_rows.begin(), work.gauss_rows.end());
}

void KeptSoil::put_back(StepState& state, Workspace& work) const
{
  const Kept& kept = *kept_;
  const Real* from = kept.points.data();
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const std::ptrdiff_t n = n_values(state.points, block);
    std::copy_n(from, n, block.data);
    from += n;
  });
  work.pressure = kept.pressure;
  if (work.with.excess) work.with.excess->pressure = kept.excess;
  if (work.with.slip) work.with.slip->blocks = kept.slips;
  if (work.with.strain_shares) work.with.strain_shares->ratios = kept.ratios;
  if (work.with.volume_change) std::ranges::copy(kept.volume_gradients, work.with.volume_change->gradients.begin());
  std::ranges::copy(kept.gauss, work.gauss.begin());
  std::ranges::copy(kept.gauss_rows, work.gauss_rows.begin());
}

}  // namespace terp
