#include "simulation/state_image.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

using Rows = PointRows<2>;

void put(StateImage& image, std::string name, std::vector<Real> values)
{
  const auto n = static_cast<std::int64_t>(values.size());
  image.arrays.push_back({std::move(name), {n}, std::move(values)});
}

void put(StateImage& image, std::string name, std::vector<std::int64_t> values)
{
  const auto n = static_cast<std::int64_t>(values.size());
  image.arrays.push_back({std::move(name), {n}, std::move(values)});
}

template <class T>
const std::vector<T>& get(const StateImage& image, std::string_view name, std::size_t size = SIZE_MAX)
{
  for (const NamedArray& array : image.arrays) {
    if (array.name != name) continue;
    const auto* values = std::get_if<std::vector<T>>(&array.values);
    if (values == nullptr || (size != SIZE_MAX && values->size() != size)) break;
    return *values;
  }
  throw FileError("the checkpoint does not fit this case: array `" + std::string(name) + "` is missing or has another size");
}

/// Time, rate and number of places of each surface, and the places of all.
void put_slip(const State& state, StateImage& image)
{
  std::vector<Real> surfaces, places;
  for (const SlipSurface& slip : state.slip) {
    surfaces.insert(surfaces.end(), {slip.time, slip.rate, static_cast<Real>(slip.line.size())});
    for (const Vec<2>& x : slip.line) places.insert(places.end(), {x[0], x[1]});
  }
  put(image, "slip/surfaces", std::move(surfaces));
  put(image, "slip/places", std::move(places));
}

void get_slip(const StateImage& image, State& state)
{
  const auto &surfaces = get<Real>(image, "slip/surfaces"), &places = get<Real>(image, "slip/places");
  std::size_t next = 0;
  for (std::size_t k = 0; k + 2 < surfaces.size(); k += 3) {
    SlipSurface slip{.time = surfaces[k], .rate = surfaces[k + 1], .line = {}};
    for (Real n = surfaces[k + 2]; n > 0.5 && next + 1 < places.size(); n -= 1.0, next += 2) slip.line.push_back({places[next], places[next + 1]});
    state.slip.push_back(std::move(slip));
  }
}

void put_points(const State& state, StateImage& image)
{
  const auto n = static_cast<std::size_t>(state.points.n_points());
  const int n_rows = state.points.n_rows();
  std::vector<std::int64_t> cell, material;
  std::vector<Real> rows;
  rows.reserve(n * n_rows);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    cell.push_back(block.cell);
    material.push_back(block.material);
    for (int r = 0; r < n_rows; ++r) rows.push_back(block.row(r)[lane]);
  });
  put(image, "points/cell", std::move(cell));
  put(image, "points/material", std::move(material));
  put(image, "points/rows", std::move(rows));
  image.arrays.back().shape = {static_cast<std::int64_t>(n), n_rows};
}

void get_points(const Model& model, const StateImage& image, State& state)
{
  state.points = PointBlocks<2>(model.mesh.n_cells(), model.n_state);
  const auto n_rows = static_cast<std::size_t>(state.points.n_rows());
  const auto& cell = get<std::int64_t>(image, "points/cell");
  const auto& material = get<std::int64_t>(image, "points/material", cell.size());
  const auto& rows = get<Real>(image, "points/rows", cell.size() * n_rows);
  const auto fits = [](const std::vector<std::int64_t>& values, std::size_t limit) {
    return std::all_of(values.begin(), values.end(), [&](std::int64_t v) { return v >= 0 && v < static_cast<std::int64_t>(limit); });
  };
  if (!fits(cell, model.mesh.cells.size()) || !fits(material, model.materials.size()))
    throw FileError("the checkpoint does not fit this case: a point lies in a cell or has a material that the case does not have");
  for (std::size_t k = 0, end = 0; k < cell.size(); k = end) {
    while (end < cell.size() && cell[end] == cell[k] && material[end] == material[k]) ++end;
    state.points.expect(static_cast<Index>(cell[k]), static_cast<Index>(material[k]), static_cast<Index>(end - k));
  }
  for (std::size_t k = 0; k < cell.size(); ++k)
    state.points.add(static_cast<Index>(cell[k]), static_cast<Index>(material[k]), {rows.data() + k * n_rows, n_rows});
  state.points.update_occupied();
  state.points.reserve(static_cast<std::int64_t>(cell.size() / 4));
}

std::vector<std::int64_t> widen(const std::vector<std::uint8_t>& flags) { return {flags.begin(), flags.end()}; }

void put_left(const State& state, StateImage& image)
{
  std::vector<std::int64_t> ids;
  std::vector<Real> values;
  for (const LeftPoint& p : state.left) {
    ids.push_back(p.id);
    values.insert(values.end(), {p.time, p.x[0], p.x[1], p.v[0], p.v[1], p.mass, p.elastic});
  }
  put(image, "left/id", std::move(ids));
  put(image, "left/values", std::move(values));
}

void get_left(const StateImage& image, State& state)
{
  const auto& ids = get<std::int64_t>(image, "left/id");
  const auto& values = get<Real>(image, "left/values", 7 * ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Real* v = &values[7 * k];
    state.left.push_back({.time = v[0], .id = ids[k], .x = {v[1], v[2]}, .v = {v[3], v[4]}, .mass = v[5], .elastic = v[6]});
  }
  state.left_told = state.left.size();
}

void put_footings(const State& state, StateImage& image)
{
  std::vector<Real> values;
  for (const FootingMeter& m : state.footings)
    values.insert(values.end(), {m.impulse[0], m.impulse[1], m.since, m.reaction[0], m.reaction[1], m.largest, m.work});
  if (!values.empty()) put(image, "footings", std::move(values));
}

void get_footings(const Model& model, const StateImage& image, State& state)
{
  state.footings.resize(model.footings.size());
  if (state.footings.empty()) return;
  const Real* v = get<Real>(image, "footings", 7 * state.footings.size()).data();
  for (FootingMeter& m : state.footings) {
    m = {.impulse = {v[0], v[1]}, .since = v[2], .reaction = {v[3], v[4]}, .largest = v[5], .work = v[6]};
    v += 7;
  }
}

/// Every id, of points and of those that left, must lie in the range that x_initial spans: other arrays are indexed by it.
void check_ids(const State& state)
{
  const auto n = static_cast<Real>(state.n_ids());
  const auto fits = [n](Real id) { return id >= 0.0 && id < n && id == std::floor(id); };
  bool all_fit = static_cast<Real>(state.points.n_points()) + static_cast<Real>(state.left.size()) == n;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) { all_fit &= fits(block.row(Rows::id)[lane]); });
  for (const LeftPoint& p : state.left) all_fit &= fits(static_cast<Real>(p.id));
  if (!all_fit) throw FileError("the checkpoint does not fit this case: its points are not those that the case seeds");
}

}  // namespace

StateImage make_image(const State& state)
{
  StateImage image{.time = state.time, .step = state.step, .arrays = {}};
  put_points(state, image);
  put(image, "x_initial", state.x_initial);
  const WorkTotals& w = state.work;
  put(image, "work", std::vector<Real>{w.gravity, w.damping, w.boundary, w.plastic, w.internal, state.start_energy, state.largest_v_999});
  put(image, "wall_s", std::vector<Real>{state.wall_s});  // the one number that differs between equal runs
  put(image, "counts", std::vector<std::int64_t>{state.clamped, state.tension_cut, state.equilibrium_steps});
  put_left(state, image);
  put_footings(state, image);
  put(image, "put_back", widen(state.put_back));
  put(image, "audit/last_eps_eq_p", state.audit.last_eps_eq_p);
  put(image, "audit/last_su", state.audit.last_su);
  put(image, "audit/fell", widen(state.audit.fell));
  put(image, "audit/rose", widen(state.audit.rose));
  put(image, "crest/initial_heights", state.crest.initial_heights);
  put(image, "crest/columns", std::vector<Real>{state.crest.columns.left, state.crest.columns.width, state.crest.base});
  put(image, "crest/time", state.crest.time);
  put(image, "crest/x", state.crest.x);
  put(image, "crest/kinetic", state.crest.kinetic);
  put_slip(state, image);
  std::vector<Real> softened;
  for (const auto& [time, fraction] : state.softened_fraction) softened.insert(softened.end(), {time, fraction});
  put(image, "softened_fraction", std::move(softened));
  return image;
}

std::int64_t count_points(const StateImage& image) { return std::ssize(get<Real>(image, "x_initial")) / 2; }

State restore(const Model& model, const StateImage& image)
{
  State state;
  state.time = image.time;
  state.step = image.step;
  get_points(model, image, state);
  state.x_initial = get<Real>(image, "x_initial");
  get_left(image, state);
  get_footings(model, image, state);
  const auto n = static_cast<std::size_t>(state.n_ids());
  check_ids(state);
  const auto& w = get<Real>(image, "work", 7);
  state.work = {.gravity = w[0], .damping = w[1], .boundary = w[2], .plastic = w[3], .internal = w[4]};
  state.start_energy = w[5];
  state.largest_v_999 = w[6];
  state.wall_s = get<Real>(image, "wall_s", 1)[0];
  const auto& counts = get<std::int64_t>(image, "counts", 3);
  state.clamped = counts[0];
  state.tension_cut = counts[1];
  state.equilibrium_steps = counts[2];
  const auto& put_back = get<std::int64_t>(image, "put_back", n);
  state.put_back.assign(put_back.begin(), put_back.end());
  const auto& fell = get<std::int64_t>(image, "audit/fell", n);
  const auto& rose = get<std::int64_t>(image, "audit/rose", n);
  state.audit = {.last_eps_eq_p = get<Real>(image, "audit/last_eps_eq_p", n), .last_su = get<Real>(image, "audit/last_su", n), .growth = std::vector<Real>(n, 0.0),
                 .fell = {fell.begin(), fell.end()}, .rose = {rose.begin(), rose.end()}};
  state.crest.initial_heights = get<Real>(image, "crest/initial_heights");
  const auto& columns = get<Real>(image, "crest/columns", 3);
  state.crest.columns = {columns[0], columns[1], static_cast<Index>(state.crest.initial_heights.size())};
  state.crest.base = columns[2];
  state.crest.time = get<Real>(image, "crest/time");
  state.crest.x = get<Real>(image, "crest/x", state.crest.time.size());
  state.crest.kinetic = get<Real>(image, "crest/kinetic", state.crest.time.size());
  get_slip(image, state);
  const auto& softened = get<Real>(image, "softened_fraction");
  for (std::size_t k = 0; k + 1 < softened.size(); k += 2) state.softened_fraction.emplace_back(softened[k], softened[k + 1]);
  return state;
}

}  // namespace terp
