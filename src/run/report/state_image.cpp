// An image is a list of arrays that are read in parts, so that a large state needs no second copy in memory. A new
// member of State that does not follow from others needs a line in arrays_of and one in restore;
// features save and load their own. The order of the
// numbers in an array is the format of checkpoints: a new number gets an array of its own, which older ones may lack.

#include "run/report/state_image.hpp"

#include "math/errors.hpp"
#include "mpm/features/feature.hpp"
#include "mpm/step/state_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace terp {
namespace {

const std::string points_room = "points/";  // arrays with an entry for each point

/// Calls f(block, lane) for n points from the first-th on, in the fixed order.
template <class F>
void for_points(const PointBlocks<2>& points, std::int64_t first, std::int64_t n, F&& f)
{
  for_each_block(points, [&](const PointBlock<2>& block) {
    const auto begin = std::max<std::int64_t>(first, 0), end = std::min<std::int64_t>(first + n, block.n);
    for (auto lane = begin; lane < end; ++lane) f(block, static_cast<Index>(lane));
    first -= block.n;  // counts from the next block
  });
}

bool has_several_bodies(const PointBlocks<2>& points)
{
  bool several = false;
  for_each_block(points, [&](const PointBlock<2>& block) { several = several || block.body != 0; });
  return several;
}

/// Bodies are saved only where not all points are of body 0.
void add_points(const State& state, ArrayWriter& arrays)
{
  const PointBlocks<2>& points = state.points;
  const auto whole_number = [&points](auto of) {
    return [&points, of](std::int64_t first, std::int64_t n) {
      std::vector<std::int64_t> values;
      values.reserve(n);
      for_points(points, first, n, [&](const PointBlock<2>& block, Index) { values.push_back(of(block)); });
      return values;
    };
  };
  const auto add = [&](const char* name, Index BlockKey::*part) {
    arrays.add({name, {points.n_points()}, whole_number([part](const PointBlock<2>& block) { return block.*part; })});
  };
  add("points/cell", &BlockKey::cell);
  add("points/material", &BlockKey::material);
  if (has_several_bodies(points)) add("points/body", &BlockKey::body);
  for (const RowInfo& row : points.table().entries()) {
    if (!row.saved) continue;
    const std::vector<std::int64_t> one{points.n_points()}, more{points.n_points(), row.n};
    arrays.add({points_room + row.name, row.n == 1 ? one : more, [&points, &row](std::int64_t first, std::int64_t n) {
                  std::vector<Real> values;
                  values.reserve(static_cast<std::size_t>(n * row.n));
                  for_points(points, first, n, [&](const PointBlock<2>& block, Index lane) {
                    for (int k = 0; k < row.n; ++k) values.push_back(block.row(row.first + k)[lane]);
                  });
                  return values;
                }});
  }
}

/// A row of the table and its values in an image, shape [n_points, n].
struct SavedRow {
  const RowInfo& row;
  const Real* values;
};

/// The rows of the points in an image: those of the table, no fewer and no more.
std::vector<SavedRow> get_rows(const RowTable& table, const StateImage& image, std::size_t n_points)
{
  std::vector<SavedRow> rows;
  for (const RowInfo& row : table.entries()) {
    if (!row.saved) continue;
    const std::string name = points_room + row.name;
    if (std::ranges::find(image.arrays, name, &NamedArray::name) == image.arrays.end())
      throw FileError(
          fmt::format("the checkpoint does not fit this case: its points have no `{}` ({}), which the "
                      "points of this case carry",
              row.name, row.meaning));
    rows.push_back({row, ArrayReader(image.arrays).reals(name, n_points * static_cast<std::size_t>(row.n)).data()});
  }
  for (const NamedArray& array : image.arrays) {
    if (!array.name.starts_with(points_room)) continue;
    const std::string name = array.name.substr(points_room.size());
    if (name != "cell" && name != "material" && name != "body" &&
        std::ranges::none_of(rows, [&](const SavedRow& saved) { return saved.row.name == name; }))
      throw FileError(fmt::format(
          "the checkpoint does not fit this case: its points carry `{}`, which the points of this case do not", name));
  }
  return rows;
}

void get_points(const Model& model, const StateImage& image, State& state)
{
  state.points = PointBlocks<2>(model.mesh->n_cells(), model.rows);
  const ArrayReader arrays(image.arrays);
  const auto& cell = arrays.wholes("points/cell");
  const auto& material = arrays.wholes("points/material", cell.size());
  const bool has_bodies = std::ranges::find(image.arrays, "points/body", &NamedArray::name) != image.arrays.end();
  const auto body = has_bodies ? arrays.wholes("points/body", cell.size()) : std::vector<std::int64_t>(cell.size());
  const std::vector<SavedRow> rows = get_rows(model.rows, image, cell.size());
  const auto fits = [](const std::vector<std::int64_t>& values, std::size_t limit) {
    return std::ranges::all_of(values, [&](std::int64_t v) { return v >= 0 && v < static_cast<std::int64_t>(limit); });
  };
  if (!fits(cell, model.mesh->cells.size()) || !fits(material, model.materials.size()) ||
      !fits(body, model.description.bodies.size()))
    throw FileError(
        "the checkpoint does not fit this case: a point lies in a cell, or is of a material or a body, "
        "that the case does not have");
  const auto key_of = [&](std::size_t k) {
    return BlockKey{static_cast<Index>(cell[k]), static_cast<Index>(material[k]), static_cast<Index>(body[k])};
  };
  for (std::size_t k = 0, end = 0; k < cell.size(); k = end) {
    while (end < cell.size() && key_of(end) == key_of(k)) ++end;
    state.points.expect(key_of(k), static_cast<Index>(end - k));
  }
  std::vector<Real> values(static_cast<std::size_t>(model.rows.n_rows()));
  for (std::size_t k = 0; k < cell.size(); ++k) {
    for (const SavedRow& saved : rows)
      std::copy_n(saved.values + k * static_cast<std::size_t>(saved.row.n), saved.row.n, &values[saved.row.first]);
    state.points.add(key_of(k), values);
  }
  state.points.update_occupied();
  state.points.reserve(static_cast<std::int64_t>(cell.size() / 4));
}

void add_left(const State& state, ArrayWriter& arrays)
{
  std::vector<std::int64_t> ids;
  std::vector<Real> values;
  for (const LeftPoint& p : state.left) {
    ids.push_back(p.id);
    values.insert(values.end(), {p.time, p.x[0], p.x[1], p.v[0], p.v[1], p.mass, p.elastic, p.volume});
  }
  arrays.copy("left/id", std::move(ids));
  arrays.copy("left/values", std::move(values));
}

std::vector<Real> values_of(const std::vector<StageRecord>& records)
{
  std::vector<Real> values;
  for (const StageRecord& r : records)
    values.insert(values.end(), {r.start, r.end, static_cast<Real>(r.steps), r.at_rest ? 1.0 : 0.0, r.fastest});
  return values;
}

std::vector<StageRecord> records_of(const std::vector<Real>& values)
{
  std::vector<StageRecord> records;
  for (std::size_t k = 0; k + 4 < values.size(); k += 5)
    records.push_back({.start = values[k],
        .end = values[k + 1],
        .steps = std::llround(values[k + 2]),
        .at_rest = values[k + 3] != 0.0,
        .fastest = values[k + 4]});
  return records;
}

void get_left(const ArrayReader& arrays, State& state)
{
  const auto& ids = arrays.wholes("left/id");
  const auto& values = arrays.reals("left/values", 8 * ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Real* v = &values[8 * k];
    state.left.push_back({.time = v[0],
        .id = ids[k],
        .x = {v[1], v[2]},
        .v = {v[3], v[4]},
        .mass = v[5],
        .elastic = v[6],
        .volume = v[7]});
  }
}

void get_reported(const StateImage& image, const ArrayReader& arrays, State& state)
{
  constexpr std::string_view head = "rows_reported/";
  for (const NamedArray& array : image.arrays)
    if (array.name.starts_with(head))
      state.rows_reported[array.name.substr(head.size())] = arrays.wholes(array.name, 1)[0];
}

void load_followers(const Model& model, const ArrayReader& arrays, State& state)
{
  for (const FollowerType* type : model.followers) {
    state.followers.push_back({type, type->make()});
    state.followers.back().follower->load(model, state, arrays.below("followers").below(type->name));
  }
}

/// Every id, of points and of those that left, must lie in the range that x_initial spans: other arrays are indexed by
/// it.
void check_ids(const Model& model, const State& state)
{
  const auto n = static_cast<Real>(state.n_ids());
  const auto fits = [n](Real id) { return id >= 0.0 && id < n && id == std::floor(id); };
  const Real n_there = static_cast<Real>(state.points.n_points()) + static_cast<Real>(state.left.size());
  bool all_fit = std::ranges::any_of(model.description.bodies, comes_or_goes) ? n_there <= n : n_there == n;
  for_each_point(
      state.points, [&](const PointBlock<2>& block, Index lane) { all_fit &= fits(block.row(Rows::id)[lane]); });
  for (const LeftPoint& p : state.left) all_fit &= fits(static_cast<Real>(p.id));
  if (!all_fit) throw FileError("the checkpoint does not fit this case: its points are not those that the case seeds");
}

/// The image's arrays; they read from the state, which must not change meanwhile.
std::vector<ArraySource> arrays_of(const State& state)
{
  std::vector<ArraySource> list;
  ArrayWriter arrays(list);
  add_points(state, arrays);
  arrays.refer("x_initial", state.x_initial);
  if (!state.moved_before.empty()) arrays.refer("moved_before", state.moved_before);
  for (const Feature* feature : all_features())
    if (feature->save != nullptr) feature->save(state, arrays);
  const WorkTotals& w = state.work;
  const EnergyMarks& marks = state.energy_marks;
  arrays.copy("work", std::vector<Real>{w.gravity, w.damping, w.boundary, w.plastic, w.internal, w.exchanged,
                          w.last_step, state.start_energy, state.largest_v_999, w.clamps, w.relaxation, w.taken,
                          w.reset, w.from_outside, marks.most_lost, marks.most_dissipated, marks.most_unexplained});
  if (state.first_step != 0) {
    arrays.copy("first_step", std::vector<std::int64_t>{state.first_step});
    arrays.copy("first_time", std::vector<Real>{state.first_time});
  }
  const bool has_stage =
      state.stage != 0 || state.stage_start != 0 || state.quiet_steps != 0 || !state.stages_done.empty();
  if (has_stage) {
    arrays.copy("stage", std::vector<std::int64_t>{state.stage, state.stage_start, state.quiet_steps});
    arrays.copy("stages_done", values_of(state.stages_done));
    if (!state.stages_done.empty() && state.stages_done.back().known_for > 0.0)
      arrays.copy("known_for", std::vector<Real>{state.stages_done.back().known_for});
  }
  if (!state.rest_marks.places.empty()) {
    arrays.refer("rest_marks", state.rest_marks.places);
    arrays.copy("rest_steps", std::vector<std::int64_t>{state.rest_marks.steps});
  }
  if (state.rest_marks.swing != 0)
    arrays.copy("swing", std::vector<std::int64_t>{state.rest_marks.swing, state.rest_marks.rests ? 1 : 0});
  if (state.mass_placed != 0.0 || state.mass_removed != 0.0)
    arrays.copy("mass_of_bodies", std::vector<Real>{state.mass_placed, state.mass_removed});
  if (w.slip != 0.0) arrays.copy("slip_work", std::vector<Real>{w.slip});
  if (state.work.outer != OuterWork{})
    arrays.copy("work_from_outside", std::vector<Real>(state.work.outer.begin(), state.work.outer.end()));
  arrays.copy("counts", std::vector<std::int64_t>{state.clamped, state.equilibrium_steps, state.frames_reported});
  if (state.has_no_start) arrays.copy("has_no_start", std::vector<std::int64_t>{1});
  for (const auto& [table, n] : state.rows_reported)
    arrays.copy("rows_reported/" + table, std::vector<std::int64_t>{n});
  add_left(state, arrays);
  arrays.refer("put_back", state.put_back);
  for (const ActiveFollower& active : state.followers) {
    ArrayWriter own = arrays.below("followers").below(active.type->name);
    active.follower->save(own);
  }
  return list;
}

}  // namespace

StateImage make_image(const State& state)
{
  StateImage image;
  for_each_part(state, std::numeric_limits<std::int64_t>::max(), [&](StateImage part) { image = std::move(part); });
  return image;
}

void for_each_part(const State& state, std::int64_t most_values, const std::function<void(StateImage)>& f)
{
  const auto start_part = [&](int number) {
    return StateImage{.time = state.time, .step = state.step, .arrays = {}, .part = number, .last = false};
  };
  StateImage part = start_part(0);
  std::int64_t room = most_values;
  for (const ArraySource& array : arrays_of(state)) {
    std::int64_t first = 0;
    do {
      if (room < array.row_length() && !part.arrays.empty()) {
        f(std::exchange(part, start_part(part.part + 1)));
        room = most_values;
      }
      const std::int64_t n =
          std::clamp<std::int64_t>(room / array.row_length(), 1, std::max<std::int64_t>(array.n_rows() - first, 1));
      part.arrays.push_back({array.name, array.shape, array.read(first, std::min(n, array.n_rows() - first)), first});
      first += n;
      room -= n * array.row_length();
    } while (first < array.n_rows());
  }
  part.last = true;
  f(std::move(part));
}

std::int64_t most_values_of_part(const State& state)
{
  return state.n_ids() <= most_points_at_once ? std::numeric_limits<std::int64_t>::max()
                                              : points_per_part * state.points.n_rows();
}

std::int64_t count_points(const StateImage& image)
{
  return std::ssize(ArrayReader(image.arrays).reals("x_initial")) / 2;
}

State restore(const Model& model, const StateImage& image)
{
  if (!(image.time >= 0.0) || !std::isfinite(image.time) || image.step < 0)
    throw FileError(fmt::format("the checkpoint cannot be of a run: step {}, t = {:.4g} s", image.step, image.time));
  State state;
  state.time = image.time;
  state.step = image.step;
  const ArrayReader arrays(image.arrays);
  get_points(model, image, state);
  state.x_initial = arrays.reals("x_initial");
  if (arrays.has("moved_before"))
    state.moved_before = arrays.reals("moved_before", static_cast<std::size_t>(state.n_ids()));
  for (const Feature* feature : all_features())
    if (feature->load != nullptr) feature->load(model, arrays, state);
  get_left(arrays, state);
  check_ids(model, state);
  const auto& w = arrays.reals("work", 17);
  state.work = {.gravity = w[0],
      .damping = w[1],
      .boundary = w[2],
      .clamps = w[9],
      .plastic = w[3],
      .internal = w[4],
      .taken = w[11],
      .reset = w[12],
      .relaxation = w[10],
      .exchanged = w[5],
      .from_outside = w[13],
      .last_step = w[6]};
  state.energy_marks = {.most_lost = w[14], .most_dissipated = w[15], .most_unexplained = w[16]};
  if (arrays.has("first_step")) {
    state.first_step = arrays.wholes("first_step", 1)[0];
    state.first_time = arrays.reals("first_time", 1)[0];
  }
  if (arrays.has("stage")) {
    const auto& stage = arrays.wholes("stage", 3);
    state.stage = stage[0], state.stage_start = stage[1], state.quiet_steps = stage[2];
    state.stages_done = records_of(arrays.reals("stages_done"));
    if (arrays.has("known_for") && !state.stages_done.empty())  // the verdict ends the last one alone
      state.stages_done.back().known_for = arrays.reals("known_for", 1)[0];
    const auto n = std::max<std::int64_t>(1, std::ssize(model.description.stages));
    if (state.stage < 0 || state.stage >= n || state.stage_start < 0 || state.stage_start > state.step)
      throw FileError("the checkpoint does not fit this case: it is of a stage that the case does not have");
  }
  if (arrays.has("rest_marks"))
    state.rest_marks = {.steps = std::max<std::int64_t>(0, arrays.wholes("rest_steps", 1)[0]),
        .places = arrays.reals("rest_marks", static_cast<std::size_t>(RestMarks::n) * state.x_initial.size())};
  if (arrays.has("swing")) {
    const auto& swing = arrays.wholes("swing", 2);
    state.rest_marks.swing = std::max<std::int64_t>(0, swing[0]), state.rest_marks.rests = swing[1] != 0;
  }
  if (arrays.has("mass_of_bodies")) {
    const auto& mass = arrays.reals("mass_of_bodies", 2);
    state.mass_placed = mass[0], state.mass_removed = mass[1];
  }
  if (arrays.has("slip_work")) state.work.slip = arrays.reals("slip_work", 1)[0];
  if (arrays.has("work_from_outside"))
    std::ranges::copy(arrays.reals("work_from_outside", n_outer_kinds), state.work.outer.begin());
  state.start_energy = w[7];
  state.largest_v_999 = w[8];
  const auto& counts = arrays.wholes("counts", 3);
  state.clamped = counts[0];
  state.equilibrium_steps = counts[1];
  state.frames_reported = counts[2];
  state.has_no_start = arrays.has("has_no_start");
  get_reported(image, arrays, state);
  state.put_back = arrays.flags("put_back", static_cast<std::size_t>(state.n_ids()));
  load_followers(model, arrays, state);
  return state;
}

}  // namespace terp
