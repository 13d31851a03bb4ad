// Motion is the 99 % quantile of the displacements: single points at a free face may fall without end. A statement on k
// windows needs k + 1 entries. While the forces still grow, the lists start anew.

#include "run/rest/search_windows.hpp"

#include "run/rest/shear_wave.hpp"
#include "model/ground/section.hpp"
#include "model/ground/ground_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terp {
namespace {

/// What 99 % of the points moved less than [m].
Real moved_by_most(const State& state)
{
  std::vector<Real> squares;
  squares.reserve(static_cast<std::size_t>(state.points.n_points()));
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Real dx = block.row(Rows::x)[lane] - state.x_initial[2 * id],
               dy = block.row(Rows::x + 1)[lane] - state.x_initial[2 * id + 1];
    squares.push_back(dx * dx + dy * dy);
  });
  if (squares.empty()) return 0.0;
  const auto at = squares.end() - static_cast<std::ptrdiff_t>(squares.size() / 100) - 1;
  std::nth_element(squares.begin(), at, squares.end());
  return std::sqrt(*at);
}

}  // namespace

SearchWindows::SearchWindows(const Model& model, const State& state, Real stiffening) : stiffening_(stiffening)
{
  const Real window = 2.0 * time_to_cross(model, state);
  steps_ = std::max<std::int64_t>(1, std::llround(window / model.dt));
  // A part with the share e of its weight out of balance goes e g/c fast under the critical damping c = 2 pi/T of a
  // layer, so e g T^2/(2 pi) in a window T.
  const Real g = std::hypot(model.gravity[0], model.gravity[1]);
  still_ = part_out_of_balance * g * stiffening * window * window / (2.0 * std::numbers::pi);
  failed_ = moved_distance(first_section(model, state.points, ground_of(model)));
}

void SearchWindows::enter(const State& state, Real out_of_balance, bool counts)
{
  const Real moved = stiffening_ * moved_by_most(state);
  if (!counts) moved_.clear(), out_of_balance_.clear();
  moved_.push_back(moved);
  out_of_balance_.push_back(out_of_balance);
}

/// In the last window, or in one further back [m].
Real SearchWindows::moved_in(std::size_t back) const
{
  const std::size_t last = moved_.size() - 1 - back;
  return moved_[last] - moved_[last - 1];
}

bool SearchWindows::at_rest() const { return moved_.size() > 1 && std::abs(moved_in(0)) <= still_; }

bool SearchWindows::runs_away() const
{
  const std::size_t n = moved_.size();
  if (n <= 3 || moved_.back() <= failed_) return false;
  const bool ever_faster = moved_in(0) > moved_in(1) && moved_in(1) > moved_in(2);
  return ever_faster && out_of_balance_[n - 1] >= out_of_balance_[n - 3];
}

std::optional<std::int64_t> SearchWindows::more_steps(Real out_of_balance, Real limit) const
{
  const std::size_t n = out_of_balance_.size();
  Real windows = 0.0;
  if (out_of_balance > limit) {
    if (n < 2 || !(out_of_balance_[n - 1] < out_of_balance_[n - 2])) return std::nullopt;
    windows = std::log(out_of_balance / limit) / std::log(out_of_balance_[n - 2] / out_of_balance_[n - 1]);
  }
  if (!at_rest()) {
    if (n < 3) return std::nullopt;
    const Real now = moved_in(0), fall = moved_in(1) / now;  // below 0: it swings, and two windows tell no fall
    if (!(fall > 1.0)) return std::nullopt;
    windows = std::max(windows, std::ceil(std::log(std::abs(now) / still_) / std::log(fall)));  // judged at its end
  }
  return std::llround(static_cast<Real>(steps_) * windows);
}

}  // namespace terp
