// What nearly every test of a run takes, and the material points of a simulation as a test looks at them.
#pragma once

#include "run/report/ledger.hpp"
#include "run/loop/simulation.hpp"
#include "run/report/state_image.hpp"
#include "support/cases.hpp"
#include "support/problems.hpp"

#include <functional>

namespace terp::test {

/// A run that all followers look at.
Simulation followed(const Case& description, int threads = 1);

/// What one of the functions warns of that look at a case before its run.
std::vector<Problem> warnings_from(
    void (*find)(const Model&, const State&, std::vector<Problem>&), const Case& description);
std::vector<Problem> warnings_from(
    void (*find)(const Model&, const StepState&, std::vector<Problem>&), const Case& description);

/// Makes steps and nothing else: no start, no guards, no rows. For states that no case describes, or a test spoils.
void make_steps(Simulation& s, std::int64_t n = 1);

struct Point {
  std::int64_t id;
  Index cell, material;
  Vec<2> x, local, v;
  Real mass, volume;
  std::array<Real, 4> sigma, strain;  ///< xx yy zz xy
  std::vector<Real> values;           ///< of the rows beyond the fixed ones
  Real eps_eq_p() const { return values.empty() ? 0.0 : values[0]; }
};

/// What a follower has to report in its own table.
std::vector<TableRow> rows_of(Simulation& s, std::string_view follower);

/// An array of real numbers as a checkpoint would hold it; of flags, how many are set.
std::vector<Real> array_of(const State& state, const std::string& name);
std::int64_t flags_set(const State& state, const std::string& name);

std::vector<Point> points_by_id(const State& state);

/// Sum over the points of mass times velocity [kg m/s per m].
Vec<2> momentum(const State& state);
/// Sum over the points of mass times |v|: what a change of momentum is measured against [kg m/s per m].
Real momentum_scale(const State& state);
Real kinetic_energy(const std::vector<Point>& points);

/// Calls change(point's block, lane) for every point; the block's rows may be written to.
template <class F>
void edit_points(State& state, F&& change)
{
  for_each_point(state.points, change);
}

void set_value(State& state, std::int64_t id, int row, Real value);

std::vector<Real> row_by_id(const State& state, int row);

/// Draws the soil anew: each point at place(where it was at t = 0) [m]. Nothing else of it changes.
void draw_points(Simulation& s, const std::function<Vec<2>(Vec<2>)>& place);

/// Expects that a run, with all followers, ends in the same bits on other numbers of threads, and where it goes on, on
/// the last of them, from a checkpoint of one thread at any of the times [s]. n_steps: that it makes; 0: to its end.
void expect_same_bits(
    const Case& c, const std::vector<int>& threads, const std::vector<Real>& times = {}, std::int64_t n_steps = 0);

/// Name of the first array that differs in any bit, "" if none does.
std::string first_difference(const StateImage& a, const StateImage& b);
/// Names of all arrays that differ in any bit, or are in one image alone, sorted.
std::vector<std::string> different_arrays(const StateImage& a, const StateImage& b);

}  // namespace terp::test
