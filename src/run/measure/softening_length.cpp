// Whether a softening length suits its run: how it compares with the cells and the section, and how much of the
// softened soil is halo, softened by its neighbours though it hardly sheared itself (docs/softening_length.md).

#include "run/measure/followers.hpp"

#include "math/nan.hpp"
#include "run/report/ledger_context.hpp"
#include "model/soils/softening_scales.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"

#include <cmath>

namespace terp {
namespace {

constexpr Real share_of_half = 0.231;  // of the strain of 95 %: ln(2)/3

/// Of the soil that has lost half of its drop by a softening length: the share of the volume whose own plastic strain
/// is below half of that which its strength follows. NaN if there is no such soil.
Real halo_share(const Model& model, const State& state)
{
  Real halo = 0.0, softened = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& material = model.materials[block.material];
    const int driver = row_of(material, Role::softening);
    if (driver < 0) return;
    const Real follows = block.row(driver)[lane], volume = block.row(Rows::volume)[lane];
    if (!(follows > share_of_half * material.law->softened_strain())) return;
    softened += volume;
    if (block.row(row_of(material, Role::plastic_strain))[lane] < 0.5 * follows) halo += volume;
  });
  return softened > 0.0 ? halo / softened : nan;
}

class SofteningLength : public Follower {
  Real over_cell_ = nan, over_height_ = nan;  ///< at t = 0
  Real over_reached_ = nan;                   ///< least so far, at the rows of the ledger

  void start(const Model& model, const State& state) override
  {
    over_height_ = nan;
    over_cell_ = over_reached_ = least_length_over_width(model, state);
    for (const SofteningScale& scale : softening_scales(model, state))
      if (scale.height > 0.0) over_height_ = std::fmax(over_height_, scale.length / scale.height);
  }
  void row(const LedgerContext& context, std::span<Real>) override
  {
    over_reached_ = std::fmin(over_reached_, least_length_over_width(context.model, context.state));
  }
  void summarise(const Model& model, const State& state, Summary& summary) const override
  {
    summary.numbers["softening_length_over_cell"] = over_cell_;
    summary.numbers["softening_length_over_cell_reached"] = over_reached_;
    summary.numbers["softening_length_over_height"] = over_height_;
    summary.numbers["halo_fraction"] = halo_share(model, state);
  }
  void save(ArrayWriter& arrays) const override
  {
    arrays.copy("scales", std::vector<Real>{over_cell_, over_height_});
    arrays.copy("reached", std::vector<Real>{over_reached_});
  }
  void load(const Model&, const State&, const ArrayReader& arrays) override
  {
    const auto& scales = arrays.reals("scales", 2);
    over_cell_ = scales[0], over_height_ = scales[1];
    over_reached_ = arrays.reals("reached", 1)[0];
  }
};

}  // namespace

const FollowerType softening_length_follower{.name = "softening_length",
    .summary = {{.name = "softening_length_over_cell",
                    .unit = "-",
                    .label = "softening length over cell",
                    .meaning = "smallest softening length over the width of a cell with its soil, at t = 0; `null`: no "
                               "softening length",
                    .is_input = true},
        {.name = "softening_length_over_cell_reached",
            .unit = "-",
            .label = "softening length over cells reached",
            .meaning = "the same of all cells to which the soil came, at the rows of the ledger",
            .is_input = true},
        {.name = "softening_length_over_height",
            .unit = "-",
            .label = "softening length over height",
            .meaning = "largest softening length over the height of the soil, at t = 0; `null`: no softening length",
            .is_input = true},
        {"halo_fraction", "-", "halo",
            "share of the soil that lost half of its drop by a softening length whose own plastic strain is below half "
            "of that which its strength follows, at the end; `null`: there is no such soil"}},
    .make = make_follower<SofteningLength>};

}  // namespace terp
