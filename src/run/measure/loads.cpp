// What the loads of a case do: their forces and where they act; loads.csv.

#include "mpm/features/loads.hpp"
#include "run/measure/followers.hpp"
#include "run/report/ledger_context.hpp"

#include <cmath>

namespace terp {
namespace {

const std::shared_ptr<const RunTable>& loads_table()
{
  static const auto table = std::make_shared<const RunTable>(RunTable{.name = "loads",
      .meaning = "force of each load and where it acts",
      .columns = {{"time", "s", "time", "of the step"}, {"load", "", "load", "name in the case file", true},
          {"pressure", "Pa", "pressure", "of the load at this time"},
          {"width", "m", "width", "of the stretch that is carried; less than the load began with where soil left"},
          {"force", "N/m", "force", "pressure times width, down positive"},
          {"x", "m", "point of application, x", "of the point of application, the middle of what the soil carries"},
          {"y", "m", "point of application, y",
              "of the point of application, the mean height at which the soil carries it"}}});
  return table;
}

struct Carried {
  Real width = 0.0, x = 0.0, y = 0.0;
};

Carried add_up(const Load& load, const PointBlocks<2>& points)
{
  Carried sum;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const Real width = block.row(load.row)[lane];
    if (width == 0.0) return;
    sum.width += width;
    sum.x += width * block.row(Rows::x)[lane];
    sum.y += width * (block.row(Rows::x + 1)[lane] + 0.5 * std::sqrt(block.row(Rows::volume)[lane]));
  });
  return sum;
}

class Loads : public Follower {
  std::vector<TableRow> rows(const Model& model, const State& state) override
  {
    std::vector<TableRow> rows;
    for (const Load& load : loads_of(model)) {
      const Carried sum = add_up(load, state.points);
      const Real pressure = pressure_of(model, load, state.time);
      if (!(sum.width > 0.0)) continue;
      rows.emplace_back(loads_table(), load.name).values = {
          state.time, pressure, sum.width, pressure * sum.width, sum.x / sum.width, sum.y / sum.width};
    }
    return rows;
  }
};

}  // namespace

const FollowerType loads_follower{.name = "loads", .table = loads_table(), .make = make_follower<Loads>};

}  // namespace terp
