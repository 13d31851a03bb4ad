// What needs energies or a walk over the points is looked at with the rows of the ledger (find_fault_in_balance).

#include "simulation/guards.hpp"

#include "mesh/mesh_error.hpp"
#include "simulation/ledger.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

struct BadPoint {
  std::int64_t id = -1;
  Index cell = -1, material = -1;
  Vec<2> x{0.0, 0.0};
  const char* what = "";
};

const char* fault_of(const PointBlock<2>& block, Index lane)
{
  const auto bad = [&](int row, int n) {
    for (int k = 0; k < n; ++k)
      if (!std::isfinite(block.row(row + k)[lane])) return true;
    return false;
  };
  if (bad(Rows::sigma, n_sym<2>)) return "stress";
  if (bad(Rows::v, 2)) return "velocity";
  if (bad(Rows::x, 2)) return "position";
  if (bad(Rows::volume, 1)) return "volume";
  return nullptr;
}

BadPoint find_bad_point(const State& state)
{
  BadPoint found;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const char* what = fault_of(block, lane);
    if (what == nullptr || found.id >= 0) return;
    found = {static_cast<std::int64_t>(block.row(Rows::id)[lane]), block.cell, block.material,
        {block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]}, what};
  });
  return found;
}

/// Smallest mass of a node that moves [kg per m].
Real smallest_nodal_mass(const Workspace& work)
{
  Real smallest = INFINITY;
  for (const Index i : work.active_nodes)
    if (work.node[i].mass > 0.0) smallest = std::min(smallest, work.node[i].mass);
  return smallest;
}

std::string describe_clamped(const State& state)
{
  return fmt::format(
      "step {}, t = {:.4f} s: {} points had to be put back at the walls, more than {:.1f} % of all\n\n"
      "  likely   soil flies out of the mesh, or runs against a side that is `free`\n"
      "  try      a larger mesh.size, or a `roller` on that side (docs/troubleshooting.md#clamped-points)",
      state.step, state.time, state.clamped, 100.0 * most_clamped);
}

std::string describe_energy(const State& state, const TableRow& row)
{
  return fmt::format(
      "step {}, t = {:.4f} s: the energy grows by itself: {:.3g} J per m that no work explains, {:.3g} J exchanged\n\n"
      "  before   kinetic {:.3g} J, elastic {:.3g} J; largest 99.9 % speed {:.3g} m/s\n"
      "  likely   an unstable time step, or a stiff body that travels far in pure FLIP\n"
      "  try      a lower time.courant, or method.flip = 0.9 (docs/troubleshooting.md#the-energy-balance-is-off)",
      state.step, state.time, row["numerical"], energy_exchanged(state), row["kinetic"], row["elastic"], row["v_999"]);
}

/// Mass of the points whose waves cross the smallest cell within a step, as a part of all: the density of a point falls
/// as it swells.
Real overtaken_share(const Model& model, const State& state)
{
  Real fast = 0.0, all = 0.0;
  const Real limit = model.mesh->smallest_altitude / model.dt;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    Real modulus = material.law->p_wave_modulus() + material.water_stiffness;
    const Real *mass = block.row(Rows::mass), *volume = block.row(Rows::volume);
    for (Index lane = 0; lane < block.n; ++lane) {
      all += mass[lane];
      if (material.varies())
        modulus = material.law->moduli(material.view(block, lane)).p_wave() + material.water_stiffness;
      if (modulus * volume[lane] > limit * limit * mass[lane]) fast += mass[lane];
    }
  });
  return all > 0.0 ? fast / all : 0.0;
}

std::string describe_time_step(const Model& model, const State& state, Real share)
{
  return fmt::format(
      "step {}, t = {:.4f} s: the time step has become too long for {:.2g} % of the soil, more than {:.0f} %\n\n"
      "  where    soil so loose that its waves cross the smallest cell ({:.3g} m) within dt = {:.3g} s\n"
      "  likely   soil that swells without end, often under tension; dt is that of the density at t = 0\n"
      "  try      a time.courant lower than {:g} (docs/troubleshooting.md#the-time-step-is-too-long)",
      state.step, state.time, 100.0 * share, 100.0 * most_overtaken, model.mesh->smallest_altitude, model.dt,
      model.description.time.courant);
}

/// What the ledger cannot know of: forces do their work at the stress of the start of a step, the soil stores sigma :
/// d_eps + 1/2 d_sigma : d_eps. Under steady loading the second terms add up to elastic/n after n steps: all of it in
/// the first step of a side that begins to move [J per m].
Real half_step_offset(const State& state, const TableRow& row)
{
  return row["elastic"] / static_cast<Real>(state.step);
}

}  // namespace

std::string find_fault_in_balance(const Model& model, const State& state, const TableRow& row)
{
  const Real exchanged = energy_exchanged(state);
  if (state.step > 0 && row["numerical"] - half_step_offset(state, row) > most_gained * exchanged)
    return describe_energy(state, row);
  if (row["numerical"] <= gain_of_harm * exchanged) return {};
  if (const Real share = overtaken_share(model, state); share > most_overtaken)
    return describe_time_step(model, state, share);
  return {};
}

std::string describe_not_finite(const Model& model, const State& state, const Workspace& work, Real speed)
{
  const BadPoint bad = find_bad_point(state);
  const std::string head = fmt::format("step {}, t = {:.4f} s: ", state.step, state.time);
  std::string where = "a node of the background mesh", what = "a nodal acceleration";
  if (bad.id >= 0) {
    const SoilMaterial& m = model.materials[bad.material];
    const Vec<2> c = model.mesh->centres[bad.cell];
    what = fmt::format("the {} of material point {}", bad.what, bad.id);
    where = fmt::format("cell {} at x = {} m, y = {} m; material `{}` ({})", bad.cell, coordinate_text(c[0]),
        coordinate_text(c[1]), m.name, m.type->name);
  }
  return head + fmt::format(
                    "{} is not a number\n\n"
                    "  where    {}\n"
                    "  before   largest 99.9 % speed {:.3g} m/s; dt = {:.3g} s, courant {:.2f}\n"
                    "  likely   an unstable time step, or a nearly empty node: smallest nodal mass {:.2g} kg "
                    "(docs/troubleshooting.md#not-a-number)",
                    what, where, speed, model.dt, model.description.time.courant, smallest_nodal_mass(work));
}

std::string find_fault(const Model& model, const State& state, const Workspace& work, Real speed)
{
  for (const SoilMaterial& material : model.materials)
    if (const std::string fault = material.law->fault(); !fault.empty())
      return fmt::format("step {}, t = {:.4f} s: {}", state.step, state.time, fault);
  if (!work.finite) return describe_not_finite(model, state, work, speed);
  if (static_cast<Real>(state.clamped) > most_clamped * static_cast<Real>(state.points.n_points()) + 1.0)
    return describe_clamped(state);
  return {};
}

}  // namespace terp
