#include "simulation/left_points.hpp"

namespace terp {

const std::shared_ptr<const RunTable>& left_table()
{
  static const auto table = std::make_shared<const RunTable>(RunTable{.name = "left_the_mesh",
      .meaning = "material points that left through open sides",
      .columns = {{"time", "s", "time", "at which it left"},
          {"id", "-", "number of the point", "of the material point"}, {"x", "m", "x", "where it left"},
          {"y", "m", "y", "where it left"}, {"v_x", "m/s", "velocity, x", "with which it left"},
          {"v_y", "m/s", "velocity, y", "with which it left"}, {"mass", "kg/m", "mass", "of the material point"}}});
  return table;
}

std::vector<TableRow> list_left_since(State& state)
{
  std::vector<TableRow> rows;
  for (; state.left_reported < state.left.size(); ++state.left_reported) {
    const LeftPoint& p = state.left[state.left_reported];
    rows.emplace_back(left_table()).values = {p.time, static_cast<Real>(p.id), p.x[0], p.x[1], p.v[0], p.v[1], p.mass};
  }
  return rows;
}

}  // namespace terp
