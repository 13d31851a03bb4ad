// Which sides of the mesh the soil comes to: from then on they act on it, whether they are meant as walls or not. Where
// soil lay from the start, at a steep side that is no wall (SideReport), what counts is that soil comes to the second
// cell above it: less is heave, and one cell more may be a matter of round-off.

#include "run/measure/followers.hpp"

#include "math/nan.hpp"
#include "run/report/ledger_context.hpp"
#include "model/loads/side_shape.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

bool holds_soil(const State& state, const CellSide& edge) { return state.points.first_block(edge.cell) >= 0; }

bool has_soil(const State& state, const NamedSide& side)
{
  return std::ranges::any_of(side.edges, [&](const CellSide& edge) { return holds_soil(state, edge); });
}

SideReport report_of(const Model& model, const NamedSide& side)
{
  return info_of(condition_of(model.description, side.name).kind).report;
}

/// The lower and the upper end of a cell's side [m]; of one that is steeper than 1:1.
struct Steep {
  Real low, high;
  bool is = false;
};

Steep heights_of(const Mesh<2>& mesh, const CellSide& edge)
{
  const auto x = mesh.corners(edge.cell);
  const Vec<2>&a = x[static_cast<std::size_t>(edge.side)], &b = x[static_cast<std::size_t>(edge.side + 1) % x.size()];
  return {std::min(a[1], b[1]), std::max(a[1], b[1]), std::abs(b[1] - a[1]) > std::abs(b[0] - a[0])};
}

/// NaN where no soil lies at a steep part of the side.
Real top_of_soil(const Model& model, const State& state, const NamedSide& side)
{
  Real top = nan;
  for (const CellSide& edge : side.edges)
    if (const Steep part = heights_of(*model.mesh, edge); part.is && holds_soil(state, edge))
      top = std::fmax(top, part.high);
  return top;
}

/// True where soil lies at the side with a cell between it and where it was.
bool has_risen(const Model& model, const State& state, const NamedSide& side, Real top)
{
  if (std::isnan(top) || report_of(model, side) != SideReport::arrival_and_rise) return false;
  return std::any_of(side.edges.begin(), side.edges.end(), [&](const CellSide& edge) {
    const Steep part = heights_of(*model.mesh, edge);
    return part.is && part.low > top + 0.5 * (part.high - part.low) && holds_soil(state, edge);
  });
}

class Sides : public Follower {
  std::vector<Real> reached_;  ///< by side of the mesh: when soil first lay in a cell at it, or rose there [s]; 0: at
                               ///< the start, NaN: not yet
  std::vector<Real> top_;      ///< top of the cells with soil at each steep side at the start [m]; NaN: none

  void start(const Model& model, const State& state) override
  {
    reached_.clear(), top_.clear();
    for (const NamedSide& side : model.mesh->sides) {
      reached_.push_back(has_soil(state, side) ? 0.0 : nan);
      top_.push_back(top_of_soil(model, state, side));
    }
  }

  void row(const LedgerContext& context, std::span<Real>) override
  {
    const Model& model = context.model;
    const State& state = context.state;
    for (std::size_t k = 0; k < reached_.size(); ++k) {
      const NamedSide& side = model.mesh->sides[k];
      const bool comes = std::isnan(reached_[k]) ? has_soil(state, side)
                                                 : reached_[k] == 0.0 && has_risen(model, state, side, top_[k]);
      if (comes) reached_[k] = state.time;
    }
  }

  /// In order of time, then of the mesh.
  void summarise(const Model& model, const State&, Summary& summary) const override
  {
    for (std::size_t k = 0; k < reached_.size(); ++k)
      if (const NamedSide& side = model.mesh->sides[k]; reached_[k] > 0.0 && report_of(model, side) != SideReport::none)
        summary.reached_sides.push_back({side.name, reached_[k], !std::isnan(top_[k])});
    std::ranges::stable_sort(summary.reached_sides, {}, &ReachedSide::time);
  }

  void save(ArrayWriter& arrays) const override
  {
    arrays.refer("reached", reached_);
    arrays.refer("top", top_);
  }
  void load(const Model& model, const State&, const ArrayReader& arrays) override
  {
    reached_ = arrays.reals("reached", model.mesh->sides.size());
    top_ = arrays.reals("top", model.mesh->sides.size());
  }
};

}  // namespace

const FollowerType sides_follower{.name = "sides", .make = make_follower<Sides>};

}  // namespace terp
