// left_the_mesh.csv: the points that crossed an open side.

#include "math/errors.hpp"
#include "run/measure/followers.hpp"
#include "run/loop/state.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"

namespace terp {
namespace {

const std::shared_ptr<const RunTable>& left_table()
{
  static const auto table = std::make_shared<const RunTable>(RunTable{.name = "left_the_mesh",
      .meaning = "material points that left through open sides",
      .columns = {{"time", "s", "time", "at which it left"},
          {"id", "-", "number of the point", "of the material point"}, {"x", "m", "x", "where it left"},
          {"y", "m", "y", "where it left"}, {"v_x", "m/s", "velocity, x", "with which it left"},
          {"v_y", "m/s", "velocity, y", "with which it left"}, {"mass", "kg/m", "mass", "of the material point"}},
      .between_ledger_rows = true});
  return table;
}

class PointsThatLeft : public Follower {
  std::size_t reported_ = 0;  ///< of state.left

  std::vector<TableRow> rows(const Model&, const State& state) override
  {
    std::vector<TableRow> rows;
    for (; reported_ < state.left.size(); ++reported_) {
      const LeftPoint& p = state.left[reported_];
      rows.emplace_back(left_table()).values = {
          p.time, static_cast<Real>(p.id), p.x[0], p.x[1], p.v[0], p.v[1], p.mass};
    }
    return rows;
  }
  void summarise(const Model&, const State& state, Summary& summary) const override
  {
    summary.points_left = std::ssize(state.left);
  }
  void save(ArrayWriter& arrays) const override
  {
    arrays.copy("reported", std::vector<std::int64_t>{static_cast<std::int64_t>(reported_)});
  }
  void load(const Model&, const State& state, const ArrayReader& arrays) override
  {
    const std::int64_t n = arrays.wholes("reported", 1)[0];
    if (n < 0 || n > std::ssize(state.left))
      throw FileError("the checkpoint does not fit this case: more points were reported as left than did leave");
    reported_ = static_cast<std::size_t>(n);
  }
};

}  // namespace

const FollowerType points_that_left_follower{
    .name = "points_that_left", .table = left_table(), .make = make_follower<PointsThatLeft>};

}  // namespace terp
