// The table serves writing, reading back, `terp explain` and the measures of verification. So a quantity has one name
// in all of them. The name is a key of summary.json: files of earlier runs are read by it, so it must not change.

#include "run/report/summary.hpp"

#include <cmath>

#include <fmt/format.h>

namespace terp {
namespace {

const SummaryQuantity quantities[] = {
    {{"scheme", "", "scheme", "`mpm_gp`, `mpm_mixed`, `standard_mpm`", true}, &Summary::scheme},
    {{"at_strength", "-", "strengths divided by",
         "factor by which all strengths were divided (docs/stability.md); where stages differ, that of the last"},
        &Summary::at_strength},
    {{"points", "-", "material points", "material points, without those that left"}, &Summary::n_points},
    {{"cells", "-", "cells", "cells of the background mesh"}, &Summary::n_cells},
    {{"steps", "-", "steps", "steps done"}, &Summary::n_steps},
    {{"dt", "s", "time step", "time step"}, &Summary::dt},
    {{"wall_s", "s", "wall time", "time spent solving, over all processes that worked on the run"}, &Summary::wall_s},
    {{"search_s", "s", "time of the search", "of it, in the search for equilibrium"}, &Summary::search_s},
    {{"search_steps", "-", "steps of the search", "iterations and steps of the search for equilibrium"},
        &Summary::search_steps},
    {{"point_steps_per_s", "1/s", "point-steps per second", "points times steps over `wall_s` less `search_s`"},
        &Summary::point_steps_per_s},
    {{"threads", "-", "threads", "of the last process"}, &Summary::threads},
    {{"instructions", "", "instruction set",
         "instruction set that the last process used: `avx512`, `avx2`, `sse2`; `native` or `plain` from a build with "
         "one set only. `avx512` and `avx2` give the same bits, `sse2` others (decision 0028)",
         true},
        &Summary::instructions},
    {{"processor", "", "processor", "as the system calls it", true}, &Summary::processor},
    {{"free_toe", "", "free toe", "of the slope that `facing` names; false: soil fills the mesh to that side", true},
        &Summary::free_toe},
    {{"front_x", "m", "front at the end", "front of the slope that `facing` names, at the end"}, &Summary::front_x},
    {{"crest_x", "m", "x of the crest at the end", "x of its crest, at the end"}, &Summary::crest_x},
    {{"crest_y", "m", "height of the crest at the end", "height of the surface there"}, &Summary::crest_y},
    {{"residual_height", "m", "highest ground that remains",
         "height of the highest ground that hangs together with the base, at the end (docs/flood.md)"},
        &Summary::residual_height},
    {{"run_out", "m", "run-out of the front",
         "of the front since t = 0; without a free toe, beyond the toe of the slope"},
        &Summary::run_out},
    {{"moved_distance", "m", "distance that counts as moved", "displacement from which on soil counts as moved"},
        &Summary::moved_distance},
    {{"moved_volume", "m^2", "volume that moved", "volume that moved, at the end"}, &Summary::moved_volume},
    {{"moved_fraction", "-", "share that moved", "its share of all volume"}, &Summary::moved_fraction},
    {{"intact_fraction", "-", "intact share of the soil that moved",
         "share of the volume that moved whose eps_eq_p is below 0.01"},
        &Summary::intact_fraction},
    {{"second_failure_time", "s", "second failure", "start of the second failure; `null`: none"},
        &Summary::second_failure_time},
    {{"max_eps_eq_p", "-", "largest eps_eq_p at the end",
         "largest at the last row of the ledger; of points that left, at the last row before; `null`: not known, as of "
         "a library whose `plastic_strain` is not given"},
        &Summary::max_eps_eq_p},
    {{"softened_strain", "-", "strain of softened soil",
         "plastic strain from which soil counts as softened, where 95 % of the softening is done (3/eta): the smallest "
         "of the laws in use; `null`: nothing softens"},
        &Summary::softened_strain},
    {{"points_eps_eq_p_fell", "-", "points whose eps_eq_p ever fell",
         "points whose plastic strain fell between any two rows of the ledger"},
        &Summary::points_eps_eq_p_fell},
    {{"points_su_rose", "-", "points whose S_u ever rose",
         "points whose strength rose between any two rows of the ledger; of a law whose strength follows from its "
         "strain alone, and of a library: rose because the strain fell"},
        &Summary::points_su_rose},
    {{"unexplained_energy", "-", "unexplained energy",
         "the most at any row of the ledger that nothing explains, of `unexplained` without sign and of what the soil "
         "has more than was given from outside, over the works from outside (gravity, boundaries, clamps, water and "
         "loads, the largest sum of their sizes so far) and the energy at t = 0 (docs/troubleshooting.md)"},
        &Summary::unexplained_energy},
    {{"energy_balance_error", "-", "energy balance error",
         "at the end, without sign: `numerical` and half of the work of the last step (docs/methods.md, section 5) "
         "over the energy exchanged, that is, the sum of the sizes of the works of gravity, damping, boundaries, "
         "water and loads, `plastic`, and the energy at t = 0"},
        &Summary::energy_balance_error},
    {{"clamped_points", "-", "points put back at a wall", "`clamped` of the ledger at the end"},
        &Summary::clamped_points},
    {{"points_left", "-", "points that left", "points that left through open sides"}, &Summary::points_left},
    {{"v_999", "m/s", "speed, largest 99.9 % quantile", "largest `v_999` of all rows of the ledger"}, &Summary::v_999},
};

}  // namespace

std::string why_known(const StageRecord& record)
{
  if (!(record.known_for > 0.0)) return "";
  return fmt::format("the answer is known: {} for {:.2g} s",
      record.at_rest ? "hardly any ground moved" : "what remains of the ground has not changed", record.known_for);
}

std::string stage_at(const std::vector<StageSummary>& stages, std::optional<Real> time)
{
  for (const auto& [name, record] : stages)  // one without an end runs
    if (time && (record.start == 0.0 || *time > record.start) && !(*time > record.end)) return name;
  return "";
}

std::span<const SummaryQuantity> summary_quantities() { return quantities; }

const SummaryQuantity* find_summary_quantity(std::string_view name)
{
  for (const SummaryQuantity& quantity : quantities)
    if (quantity.info.name == name) return &quantity;
  return nullptr;
}

std::optional<Real> SummaryQuantity::number(const Summary& summary) const
{
  const auto read = [&](auto of) -> std::optional<Real> {
    const auto& value = summary.*of;
    using Kind = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Kind, std::optional<Real>>)
      return value;
    else if constexpr (std::is_same_v<Kind, std::string>)
      return std::nullopt;
    else
      return static_cast<Real>(value);
  };
  const std::optional<Real> value = std::visit(read, member);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace terp
