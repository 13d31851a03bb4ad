#include "mpm/step/workspace.hpp"
#include "support/simulations.hpp"

#include "mpm/mesh/locate.hpp"

#include "run/measure/followers.hpp"
#include "mpm/step/state_arrays.hpp"

#include <cstring>

namespace terp::test {

Simulation followed(const Case& description, int threads) { return Simulation(description, threads, all_followers()); }

void make_steps(Simulation& s, std::int64_t n)
{
  for (std::int64_t k = 0; k < n; ++k) make_step(s.model, s.state, s.work);
}

template <class Find>
static std::vector<Problem> warnings_of(Find find, const Case& description)
{
  Model model = build_model(description, 1);
  const State state = build_state(model);
  std::vector<Problem> warnings;
  find(model, state, warnings);
  return warnings;
}

std::vector<Problem> warnings_from(
    void (*find)(const Model&, const State&, std::vector<Problem>&), const Case& description)
{
  return warnings_of(find, description);
}

std::vector<Problem> warnings_from(
    void (*find)(const Model&, const StepState&, std::vector<Problem>&), const Case& description)
{
  return warnings_of(find, description);
}

std::vector<Point> points_by_id(const State& state)
{
  std::vector<Point> points;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto at = [&](int row) { return block.row(row)[lane]; };
    Point p{.id = static_cast<std::int64_t>(at(Rows::id)),
        .cell = block.cell,
        .material = block.material,
        .x = {at(Rows::x), at(Rows::x + 1)},
        .local = {at(Rows::xi), at(Rows::xi + 1)},
        .v = {at(Rows::v), at(Rows::v + 1)},
        .mass = at(Rows::mass),
        .volume = at(Rows::volume),
        .sigma = {},
        .strain = {},
        .values = {}};
    for (int k = 0; k < 4; ++k) {
      p.sigma[k] = at(Rows::sigma + k);
      p.strain[k] = at(Rows::strain + k);
    }
    for (int k = 0; k < state.points.n_rows() - Rows::state; ++k) p.values.push_back(at(Rows::state + k));
    points.push_back(std::move(p));
  });
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.id < b.id; });
  return points;
}

std::vector<TableRow> rows_of(Simulation& s, std::string_view follower)
{
  for (const ActiveFollower& active : s.state.followers)
    if (active.type->name == follower) return active.follower->rows(s.model, s.state);
  return {};
}

std::vector<Real> array_of(const State& state, const std::string& name)
{
  const StateImage image = make_image(state);
  return ArrayReader(image.arrays).reals(name);
}

std::int64_t flags_set(const State& state, const std::string& name)
{
  const StateImage image = make_image(state);
  return std::ranges::count(ArrayReader(image.arrays).wholes(name), 1);
}

Vec<2> momentum(const State& state)
{
  Vec<2> sum{0.0, 0.0};
  for (const Point& p : points_by_id(state))
    for (int d = 0; d < 2; ++d) sum[d] += p.mass * p.v[d];
  return sum;
}

Real momentum_scale(const State& state)
{
  Real sum = 0.0;
  for (const Point& p : points_by_id(state)) sum += p.mass * std::hypot(p.v[0], p.v[1]);
  return sum;
}

Real kinetic_energy(const std::vector<Point>& points)
{
  Real sum = 0.0;
  for (const Point& p : points) sum += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]);
  return sum;
}

namespace {

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_array(const NamedArray& a, const NamedArray& b)
{
  if (a.name != b.name || a.shape != b.shape || a.values.index() != b.values.index()) return false;
  if (const auto* reals = std::get_if<std::vector<Real>>(&a.values))
    return same_bits(*reals, std::get<std::vector<Real>>(b.values));
  return same_bits(std::get<std::vector<std::int64_t>>(a.values), std::get<std::vector<std::int64_t>>(b.values));
}

}  // namespace

void expect_same_bits(
    const Case& c, const std::vector<int>& threads, const std::vector<Real>& times, std::int64_t n_steps)
{
  const auto end_on = [&](int n_threads, const StateImage* from) {
    Simulation s = followed(c, n_threads);
    EXPECT_EQ(s.work.threads.count(), n_threads);
    if (from) s.restore(*from);
    n_steps > 0 ? s.step(n_steps - s.state.step) : s.run();
    return s.save();
  };
  const StateImage whole = end_on(1, nullptr);
  for (const int n : threads) EXPECT_EQ(first_difference(whole, end_on(n, nullptr)), "") << n << " threads";
  for (const Real time : times) {
    Simulation first = followed(c);
    first.advance_to(time);
    const StateImage image = first.save();
    EXPECT_EQ(first_difference(whole, end_on(threads.empty() ? 1 : threads.back(), &image)), "")
        << "from " << time << " s on";
  }
}

std::string first_difference(const StateImage& a, const StateImage& b)
{
  if (a.time != b.time || a.step != b.step) return "time or step";
  if (a.arrays.size() != b.arrays.size()) return "number of arrays";
  for (std::size_t k = 0; k < a.arrays.size(); ++k)
    if (!same_array(a.arrays[k], b.arrays[k])) return a.arrays[k].name;
  return "";
}

std::vector<std::string> different_arrays(const StateImage& a, const StateImage& b)
{
  std::set<std::string> names;
  const auto look = [&](const StateImage& one, const StateImage& other) {
    for (const NamedArray& array : one.arrays) {
      const auto same = [&](const NamedArray& there) { return same_array(there, array); };
      if (std::ranges::none_of(other.arrays, same)) names.insert(array.name);
    }
  };
  look(a, b), look(b, a);
  return {names.begin(), names.end()};
}

void set_value(State& state, std::int64_t id, int row, Real value)
{
  int n_points = 0;
  edit_points(state, [&](const PointBlock<2>& block, Index lane) {
    if (static_cast<std::int64_t>(block.row(Rows::id)[lane]) != id) return;
    block.row(row)[lane] = value;
    ++n_points;
  });
  EXPECT_EQ(n_points, 1) << "points with the id " << id;
}

std::vector<Real> row_by_id(const State& state, int row)
{
  std::vector<Real> values(static_cast<std::size_t>(state.n_ids()));
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    values[static_cast<std::size_t>(block.row(Rows::id)[lane])] = block.row(row)[lane];
  });
  return values;
}

void draw_points(Simulation& s, const std::function<Vec<2>(Vec<2>)>& place)
{
  const Mesh<2>& mesh = *s.model.mesh;
  const PointBlocks<2>& before = s.state.points;
  PointBlocks<2> drawn(mesh.n_cells(), before.table());
  std::vector<Real> values(static_cast<std::size_t>(before.n_rows()));
  for_each_point(before, [&](const PointBlock<2>& block, Index lane) {
    for (int r = 0; r < before.n_rows(); ++r) values[static_cast<std::size_t>(r)] = block.row(r)[lane];
    const auto id = static_cast<std::size_t>(values[Rows::id]);
    const Vec<2> x = place({s.state.x_initial[2 * id], s.state.x_initial[2 * id + 1]});
    const Location at = locate(mesh, x, 0);
    for (int d = 0; d < 2; ++d) values[Rows::x + d] = x[d], values[Rows::xi + d] = at.local[d];
    drawn.add({at.cell, block.material, block.body}, values);
  });
  drawn.update_occupied();
  s.state.points = std::move(drawn);
}

}  // namespace terp::test
