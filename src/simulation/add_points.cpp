// Numbers of points count all that were seeded, wanted or not: a body that comes in a later stage has its numbers from
// the start. Blocks get their size before they are filled, which needs the batch sorted by key; the points themselves
// keep the order of seeding within a block.

#include "simulation/add_points.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

using Rows = PointRows<2>;

/// Makes blocks of the right size before they are filled: no growth, no waste.
void expect_points(std::vector<BlockKey> keys, State& state)
{
  std::ranges::sort(keys);
  for (std::size_t k = 0, end = 0; k < keys.size(); k = end) {
    while (end < keys.size() && keys[end] == keys[k]) ++end;
    state.points.expect(keys[k], static_cast<Index>(end - k));
  }
}

/// values: what all points begin with, shape [n_rows].
void add_point(const Model& model, const NewPoint& p, std::size_t id, std::vector<Real>& values, State& state)
{
  for (int d = 0; d < 2; ++d) {
    values[Rows::x + d] = p.x[d];
    values[Rows::xi + d] = p.local[d];
    values[Rows::v + d] = p.v[d];
  }
  values[Rows::mass] = p.volume * model.materials[p.key.material].density;
  values[Rows::volume] = p.volume;
  for (const RowInfo& row : model.rows.added())
    if (!row.initials.empty()) values[row.first] = row.initial_in(p.key.material);
  if (model.inverse_extent >= 0) values[model.inverse_extent] = 1.0 / std::sqrt(p.volume);
  values[Rows::id] = static_cast<Real>(id);
  state.points.add(p.key, values);
}

}  // namespace

void add_points(
    const Model& model, PointBatches points, const std::function<bool(const BodyCase&)>& wanted, State& state)
{
  std::vector<Real> values(static_cast<std::size_t>(model.rows.n_rows()));
  for (const RowInfo& row : model.rows.entries()) std::fill_n(values.begin() + row.first, row.n, row.initial);
  std::vector<bool> is_wanted;
  for (const BodyCase& body : model.description.bodies) is_wanted.push_back(wanted(body));
  std::size_t id = 0;
  for (auto& batch : points) {
    std::vector<BlockKey> keys;
    for (const NewPoint& p : batch)
      if (is_wanted[static_cast<std::size_t>(p.body)]) keys.push_back(p.key);
    expect_points(std::move(keys), state);
    for (const NewPoint& p : batch) {
      if (is_wanted[static_cast<std::size_t>(p.body)]) add_point(model, p, id, values, state);
      ++id;
    }
    PointBatches::value_type().swap(batch);
  }
}

}  // namespace terp
