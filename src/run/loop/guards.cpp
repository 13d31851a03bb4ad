// What needs energies or a walk over the points is looked at with the rows of the ledger (find_fault_in_balance).

#include "run/loop/guards.hpp"

#include "model/meshes/mesh_error.hpp"
#include "run/report/ledger.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

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

/// What lies around the fastest point.
struct Place {
  Index cell = -1;
  Vec<2> x{0.0, 0.0};                       ///< of the point [m]
  Real speed = 0.0;                         ///< [m/s]
  std::set<std::string> materials;          ///< of the cell and of those that share a node with it
  Real softest = INFINITY, stiffest = 0.0;  ///< their moduli K + 4G/3 [Pa]

  Real contrast() const { return stiffest / softest; }
};

Place find_fastest_place(const Model& model, const State& state)
{
  Place place;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Real speed = std::hypot(block.row(Rows::v)[lane], block.row(Rows::v + 1)[lane]);
    if (place.cell < 0 || speed > place.speed)
      place.cell = block.cell, place.x = {block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]}, place.speed = speed;
  });
  if (place.cell < 0) return place;
  const Mesh<2>& mesh = *model.mesh;
  for (const Index node : mesh.cells[place.cell])
    for (Index k = mesh.first_cell_of_node[node]; k < mesh.first_cell_of_node[node + 1]; ++k)
      for_each_block(state.points, mesh.cells_of_node[k].cell, [&](const PointBlock<2>& block, Index) {
        const SoilMaterial& material = model.materials[block.material];
        const Real modulus = material.law->p_wave_modulus();
        place.materials.insert(material.name);
        place.softest = std::min(place.softest, modulus);
        place.stiffest = std::max(place.stiffest, modulus);
      });
  return place;
}

/// The message for a balance of energy that is off. head: what is wrong with it.
std::string describe_energy(const Model& model, const State& state, const TableRow& row, const std::string& head)
{
  constexpr Real few = 9.0, high = 10.0;  // points per cell; contrast of stiffness: docs/limits.md
  const Place place = find_fastest_place(model, state);
  const Real per_cell = static_cast<Real>(state.points.n_points()) /
                        static_cast<Real>(std::max<std::size_t>(state.points.occupied().size(), 1));
  std::string likely, next;
  const auto add = [&](const char* cause, const char* cure) {
    likely += (likely.empty() ? "" : ", or ") + std::string(cause);
    next += (next.empty() ? "" : ", or ") + std::string(cure);
  };
  if (per_cell < few) add("too few points per cell where soil flows", "body.points_per_cell of 3 at least");
  if (place.contrast() > high) add("soils of very different stiffness in one cell", "cells that follow their border");
  add("an unstable time step", "a lower time.courant");
  add("a stiff body that travels far in pure FLIP", "method.flip = 0.9");
  return fmt::format(
      "step {}, t = {:.4f} s: {}\n\n"
      "  before   kinetic {:.3g} J, elastic {:.3g} J; largest 99.9 % speed {:.3g} m/s\n"
      "  where    the fastest point, {:.3g} m/s, is in cell {} at x = {} m, y = {} m; soil there: {}\n"
      "           {:.2g} points per cell of soil; stiffest over softest soil there {:.3g}\n"
      "  likely   {}\n"
      "  try      {} (docs/troubleshooting.md#the-energy-balance-is-off)",
      state.step, state.time, head, row["kinetic"], row["elastic"], row["v_999"], place.speed, place.cell,
      coordinate_text(place.x[0]), coordinate_text(place.x[1]), fmt::join(place.materials, ", "), per_cell,
      place.contrast(), likely, next);
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
  return (row["elastic"] + row["pore_elastic"]) / static_cast<Real>(std::max<std::int64_t>(state.step, 1));
}

/// Terp knows neither what a law of a library stores nor what it dissipates.
bool has_library_law(const Model& model)
{
  return std::ranges::any_of(model.materials, [](const SoilMaterial& m) { return m.type->by_library; });
}

/// Energy that is wrong at a row [J per m]; none below zero.
struct Faults {
  Real unexplained = 0.0;  ///< by the books, whatever its sign
  Real gained = 0.0;       ///< the same, where it is no loss
  Real made = 0.0;         ///< by no books: more than the soil was given from outside, or than it had before
  Real undone = 0.0;       ///< of plastic work and slip
};

/// Enters the row in the marks of the state.
Faults find_wrong_energy(const Model& model, State& state, const TableRow& row)
{
  EnergyMarks& marks = state.energy_marks;
  // Velocities are those of half a step before the places (docs/methods.md, section 5).
  const Real half_step = 0.5 * state.work.last_step, offset = half_step_offset(state, row);
  const Real stored = row["kinetic"] + row["elastic"] + row["pore_elastic"] + row["left_energy"] + half_step;
  const Real lost = state.work.outside() + state.start_energy - stored;
  const Real dissipated = state.work.plastic + state.work.slip;
  // A known loss that swings back elsewhere, as in soil that rings, leaves the balance as a whole in order.
  const Real whole = std::abs(row["numerical"] + half_step), rest = std::abs(row["unexplained"] + half_step);
  Faults faults{.unexplained = std::max(std::min(whole, rest) - offset, 0.0),
      .gained = std::max(std::min(row["numerical"], row["unexplained"]) + half_step - offset, 0.0),
      .made = std::max(marks.most_lost - lost - offset, 0.0),
      .undone = has_library_law(model) ? 0.0 : std::max(marks.most_dissipated - dissipated, 0.0)};
  if (!has_library_law(model)) {
    marks.most_lost = std::max(marks.most_lost, lost);
    marks.most_dissipated = std::max(marks.most_dissipated, dissipated);
  }
  marks.most_unexplained = std::max({marks.most_unexplained, faults.unexplained, faults.made});
  return faults;
}

}  // namespace

Real unexplained_share(const State& state)
{
  const Real most = state.energy_marks.most_unexplained, scale = energy_from_outside(state);
  return most > 0.0 ? most / scale : 0.0;
}

/// Terms of order dt are a part 1/n of what is stored after n steps: more than 5 % of it before this step.
constexpr std::int64_t first_judged = 20;

std::string find_fault_in_balance(const Model& model, State& state, const TableRow& row)
{
  if (state.step < first_judged) return {};
  const Faults faults = find_wrong_energy(model, state, row);
  const Real scale = energy_from_outside(state);
  if (faults.made > most_unexplained * scale)
    return describe_energy(model, state, row,
        fmt::format("the energy grows by itself: {:.3g} J per m come from nowhere, {:.3g} J came from outside",
            faults.made, scale));
  if (faults.unexplained > most_unexplained * scale)
    return describe_energy(model, state, row,
        fmt::format("{:.3g} J per m of energy {} and nothing explains it, {:.3g} J came from outside",
            faults.unexplained, row["unexplained"] > 0.0 ? "were gained" : "were lost", scale));
  if (faults.undone > most_undone * scale)
    return describe_energy(model, state, row,
        fmt::format(
            "{:.3g} J per m of plastic work and slip were given back, which no soil can, {:.3g} J came from outside",
            faults.undone, scale));
  if (std::max(faults.gained, faults.made) <= unexplained_that_fails * scale) return {};
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
