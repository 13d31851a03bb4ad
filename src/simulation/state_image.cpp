#include "simulation/state_image.hpp"

#include "base/errors.hpp"
#include "simulation/reached_sides.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace terp {
namespace {

using Rows = PointRows<2>;

using Values = decltype(NamedArray::values);

const std::string points_room = "points/";  // arrays with an entry for each point

/// An array of an image, and how to read n of its rows from `first` on.
struct ArraySource {
  std::string name;
  std::vector<std::int64_t> shape;
  std::function<Values(std::int64_t first, std::int64_t n)> read;

  std::int64_t n_rows() const { return shape[0]; }
  std::int64_t row_length() const { return shape.size() == 2 ? shape[1] : 1; }
};

/// An array that the state holds as it is, or, of flags, as bits.
template <class T>
ArraySource kept(std::string name, const std::vector<T>& values)
{
  using Kept = std::conditional_t<std::is_same_v<T, Real>, Real, std::int64_t>;
  return {std::move(name), {std::ssize(values)}, [&values](std::int64_t first, std::int64_t n) {
            return std::vector<Kept>(values.begin() + first, values.begin() + first + n);
          }};
}

/// A few numbers.
template <class T>
ArraySource few(std::string name, std::vector<T> values)
{
  const auto size = std::ssize(values);
  return {std::move(name), {size}, [values = std::move(values)](std::int64_t first, std::int64_t n) {
            return std::vector<T>(values.begin() + first, values.begin() + first + n);
          }};
}

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

void add_points(const State& state, std::vector<ArraySource>& arrays)
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
  arrays.push_back(
      {"points/cell", {points.n_points()}, whole_number([](const PointBlock<2>& block) { return block.cell; })});
  arrays.push_back({"points/material", {points.n_points()},
      whole_number([](const PointBlock<2>& block) { return block.material; })});
  for (const RowInfo& row : points.table().entries()) {
    if (!row.saved) continue;
    const std::vector<std::int64_t> one{points.n_points()}, more{points.n_points(), row.n};
    arrays.push_back(
        {points_room + row.name, row.n == 1 ? one : more, [&points, &row](std::int64_t first, std::int64_t n) {
           std::vector<Real> values;
           values.reserve(static_cast<std::size_t>(n * row.n));
           for_points(points, first, n, [&](const PointBlock<2>& block, Index lane) {
             for (int k = 0; k < row.n; ++k) values.push_back(block.row(row.first + k)[lane]);
           });
           return values;
         }});
  }
}

[[noreturn]] void throw_missing(std::string_view name)
{
  throw FileError(
      "the checkpoint does not fit this case: array `" + std::string(name) + "` is missing or has another size");
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
  throw_missing(name);
}

bool holds(const StateImage& image, std::string_view name)
{
  return std::any_of(
      image.arrays.begin(), image.arrays.end(), [&](const NamedArray& array) { return array.name == name; });
}

/// What checkpoints hold since format 4, or 5.
void get_since_format_4(const Model& model, const StateImage& image, State& state)
{
  start_following_sides(model, state);  // of an earlier one: as if the soil that is there now had always been there
  if (holds(image, "side_reached")) state.side_reached = get<Real>(image, "side_reached", model.mesh->sides.size());
  if (holds(image, "side_top")) state.side_top = get<Real>(image, "side_top", model.mesh->sides.size());
  if (holds(image, "work_exchanged")) state.work.exchanged = get<Real>(image, "work_exchanged", 1)[0];
  if (holds(image, "last_step_work")) state.work.last_step = get<Real>(image, "last_step_work", 1)[0];
}

/// The first surface, and of each slope its crest over time; time, rate and number of places of each slip surface, and
/// the places of all.
void add_failure(const State& state, std::vector<ArraySource>& arrays)
{
  const Section& section = state.section;
  arrays.push_back(kept("section/heights", section.heights));
  arrays.push_back(
      few("section/columns", std::vector<Real>{section.columns.left, section.columns.width, section.base}));
  for (std::size_t k = 0; k < state.slopes.size(); ++k) {
    const SlopeFailure& slope = state.slopes[k];
    const std::string room = fmt::format("slope_{}/", k);
    arrays.push_back(kept(room + "time", slope.crest.time));
    arrays.push_back(kept(room + "crest", slope.crest.x));
    arrays.push_back(kept(room + "kinetic", slope.crest.kinetic));
    std::vector<Real> surfaces, places;
    for (const SlipSurface& slip : slope.slip) {
      surfaces.insert(surfaces.end(), {slip.time, slip.rate, static_cast<Real>(slip.line.size())});
      for (const Vec<2>& x : slip.line) places.insert(places.end(), {x[0], x[1]});
    }
    arrays.push_back(few(room + "slip_surfaces", std::move(surfaces)));
    arrays.push_back(few(room + "slip_places", std::move(places)));
  }
}

void get_slip(const std::vector<Real>& surfaces, const std::vector<Real>& places, SlopeFailure& slope)
{
  std::size_t next = 0;
  for (std::size_t k = 0; k + 2 < surfaces.size(); k += 3) {
    SlipSurface slip{.time = surfaces[k], .rate = surfaces[k + 1], .line = {}};
    for (Real n = surfaces[k + 2]; n > 0.5 && next + 1 < places.size(); n -= 1.0, next += 2)
      slip.line.push_back({places[next], places[next + 1]});
    slope.slip.push_back(std::move(slip));
  }
}

/// The slopes follow from the first surface.
void get_failure(const StateImage& image, State& state)
{
  const auto& heights = get<Real>(image, "section/heights");
  const auto& columns = get<Real>(image, "section/columns", 3);
  const bool fits = !heights.empty() && std::isfinite(columns[0]) && std::isfinite(columns[1]) && columns[1] > 0.0;
  if (!fits) throw FileError("the checkpoint does not fit this case: its first surface has no columns");
  state.section = {{columns[0], columns[1], static_cast<Index>(heights.size())}, heights, columns[2]};
  for (const Slope& slope : find_slopes(state.section)) {
    const std::string room = fmt::format("slope_{}/", state.slopes.size());
    const auto& time = get<Real>(image, room + "time");
    SlopeFailure followed{{.slope = slope,
                              .width = columns[1],
                              .time = time,
                              .x = get<Real>(image, room + "crest", time.size()),
                              .kinetic = get<Real>(image, room + "kinetic", time.size())},
        {}};
    get_slip(get<Real>(image, room + "slip_surfaces"), get<Real>(image, room + "slip_places"), followed);
    state.slopes.push_back(std::move(followed));
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
    if (!holds(image, name))
      throw FileError(
          fmt::format("the checkpoint does not fit this case: its points have no `{}` ({}), which the "
                      "points of this case carry",
              row.name, row.meaning));
    rows.push_back({row, get<Real>(image, name, n_points * static_cast<std::size_t>(row.n)).data()});
  }
  for (const NamedArray& array : image.arrays) {
    if (!array.name.starts_with(points_room)) continue;
    const std::string name = array.name.substr(points_room.size());
    if (name != "cell" && name != "material" &&
        std::ranges::none_of(rows, [&](const SavedRow& saved) { return saved.row.name == name; }))
      throw FileError(fmt::format(
          "the checkpoint does not fit this case: its points carry `{}`, which the points of this case do not", name));
  }
  return rows;
}

void get_points(const Model& model, const StateImage& image, State& state)
{
  state.points = PointBlocks<2>(model.mesh->n_cells(), model.rows);
  const auto& cell = get<std::int64_t>(image, "points/cell");
  const auto& material = get<std::int64_t>(image, "points/material", cell.size());
  const std::vector<SavedRow> rows = get_rows(model.rows, image, cell.size());
  const auto fits = [](const std::vector<std::int64_t>& values, std::size_t limit) {
    return std::all_of(
        values.begin(), values.end(), [&](std::int64_t v) { return v >= 0 && v < static_cast<std::int64_t>(limit); });
  };
  if (!fits(cell, model.mesh->cells.size()) || !fits(material, model.materials.size()))
    throw FileError(
        "the checkpoint does not fit this case: a point lies in a cell or has a material that the case does not have");
  for (std::size_t k = 0, end = 0; k < cell.size(); k = end) {
    while (end < cell.size() && cell[end] == cell[k] && material[end] == material[k]) ++end;
    state.points.expect(static_cast<Index>(cell[k]), static_cast<Index>(material[k]), static_cast<Index>(end - k));
  }
  std::vector<Real> values(static_cast<std::size_t>(model.rows.n_rows()));
  for (std::size_t k = 0; k < cell.size(); ++k) {
    for (const SavedRow& saved : rows)
      std::copy_n(saved.values + k * static_cast<std::size_t>(saved.row.n), saved.row.n, &values[saved.row.first]);
    state.points.add(static_cast<Index>(cell[k]), static_cast<Index>(material[k]), values);
  }
  state.points.update_occupied();
  state.points.reserve(static_cast<std::int64_t>(cell.size() / 4));
}

void add_left(const State& state, std::vector<ArraySource>& arrays)
{
  std::vector<std::int64_t> ids;
  std::vector<Real> values, volumes;
  for (const LeftPoint& p : state.left) {
    ids.push_back(p.id);
    volumes.push_back(p.volume);
    values.insert(values.end(), {p.time, p.x[0], p.x[1], p.v[0], p.v[1], p.mass, p.elastic});
  }
  arrays.push_back(few("left/id", std::move(ids)));
  arrays.push_back(few("left/values", std::move(values)));
  arrays.push_back(few("left/volume", std::move(volumes)));
}

void get_left(const StateImage& image, State& state)
{
  const auto& ids = get<std::int64_t>(image, "left/id");
  const auto& values = get<Real>(image, "left/values", 7 * ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Real* v = &values[7 * k];
    state.left.push_back(
        {.time = v[0], .id = ids[k], .x = {v[1], v[2]}, .v = {v[3], v[4]}, .mass = v[5], .elastic = v[6]});
  }
  if (holds(image, "left/volume")) {  // since format 5
    const auto& volumes = get<Real>(image, "left/volume", ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) state.left[k].volume = volumes[k];
  }
  state.left_reported = state.left.size();
}

void add_footings(const State& state, std::vector<ArraySource>& arrays)
{
  std::vector<Real> values;
  for (const FootingMeter& m : state.footings)
    values.insert(values.end(), {m.impulse[0], m.impulse[1], m.since, m.reaction[0], m.reaction[1], m.largest, m.work});
  if (!values.empty()) arrays.push_back(few("footings", std::move(values)));
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

/// Every id, of points and of those that left, must lie in the range that x_initial spans: other arrays are indexed by
/// it.
void check_ids(const State& state)
{
  const auto n = static_cast<Real>(state.n_ids());
  const auto fits = [n](Real id) { return id >= 0.0 && id < n && id == std::floor(id); };
  bool all_fit = static_cast<Real>(state.points.n_points()) + static_cast<Real>(state.left.size()) == n;
  for_each_point(
      state.points, [&](const PointBlock<2>& block, Index lane) { all_fit &= fits(block.row(Rows::id)[lane]); });
  for (const LeftPoint& p : state.left) all_fit &= fits(static_cast<Real>(p.id));
  if (!all_fit) throw FileError("the checkpoint does not fit this case: its points are not those that the case seeds");
}

/// The image's arrays; they read from the state, which must not change meanwhile.
std::vector<ArraySource> arrays_of(const State& state)
{
  std::vector<ArraySource> arrays;
  add_points(state, arrays);
  arrays.push_back(kept("x_initial", state.x_initial));
  const WorkTotals& w = state.work;
  arrays.push_back(few("work", std::vector<Real>{w.gravity, w.damping, w.boundary, w.plastic, w.internal,
                                   state.start_energy, state.largest_v_999}));
  arrays.push_back(few("work_exchanged", std::vector<Real>{w.exchanged}));
  arrays.push_back(few("last_step_work", std::vector<Real>{w.last_step}));
  arrays.push_back(kept("side_reached", state.side_reached));
  arrays.push_back(kept("side_top", state.side_top));
  arrays.push_back(
      few("counts", std::vector<std::int64_t>{state.clamped, state.equilibrium_steps, state.frames_reported}));
  for (const auto& [table, n] : state.rows_reported)
    arrays.push_back(few("rows_reported/" + table, std::vector<std::int64_t>{n}));
  add_left(state, arrays);
  add_footings(state, arrays);
  arrays.push_back(kept("put_back", state.put_back));
  arrays.push_back(kept("audit/last_eps_eq_p", state.audit.last_eps_eq_p));
  arrays.push_back(kept("audit/last_su", state.audit.last_su));
  arrays.push_back(kept("audit/fell", state.audit.fell));
  arrays.push_back(kept("audit/rose", state.audit.rose));
  add_failure(state, arrays);
  std::vector<Real> softened;
  for (const auto& [time, fraction] : state.softened_fraction) softened.insert(softened.end(), {time, fraction});
  arrays.push_back(few("softened_fraction", std::move(softened)));
  return arrays;
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

std::int64_t count_points(const StateImage& image) { return std::ssize(get<Real>(image, "x_initial")) / 2; }

State restore(const Model& model, const StateImage& image)
{
  if (!(image.time >= 0.0) || !std::isfinite(image.time) || image.step < 0)
    throw FileError(fmt::format("the checkpoint cannot be of a run: step {}, t = {:.4g} s", image.step, image.time));
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
  get_since_format_4(model, image, state);
  state.start_energy = w[5];
  state.largest_v_999 = w[6];
  const auto& counts = get<std::int64_t>(image, "counts", 3);
  state.clamped = counts[0];
  state.equilibrium_steps = counts[1];
  state.frames_reported = counts[2];
  for (const NamedArray& array : image.arrays)
    if (constexpr std::string_view head = "rows_reported/"; array.name.starts_with(head))
      state.rows_reported[array.name.substr(head.size())] = get<std::int64_t>(image, array.name, 1)[0];
  const auto& put_back = get<std::int64_t>(image, "put_back", n);
  state.put_back.assign(put_back.begin(), put_back.end());
  const auto& fell = get<std::int64_t>(image, "audit/fell", n);
  const auto& rose = get<std::int64_t>(image, "audit/rose", n);
  const auto& last_su = get<Real>(image, "audit/last_su");
  if (!last_su.empty() && last_su.size() != n) throw_missing("audit/last_su");
  state.audit = {.last_eps_eq_p = get<Real>(image, "audit/last_eps_eq_p", n),
      .last_su = last_su,
      .fell = {fell.begin(), fell.end()},
      .rose = {rose.begin(), rose.end()}};
  get_failure(image, state);
  const auto& softened = get<Real>(image, "softened_fraction");
  for (std::size_t k = 0; k + 1 < softened.size(); k += 2)
    state.softened_fraction.emplace_back(softened[k], softened[k + 1]);
  return state;
}

}  // namespace terp
