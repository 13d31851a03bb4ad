// Between two neighbouring breaks the same sides lie above each other in the same order, so that order is found once.

#include "model/bodies/drawn_columns.hpp"

#include <algorithm>

namespace terp {
namespace {

constexpr Real together = 1e-9;  // [m]: sides that are nearer at a break meet there

struct BodySide {
  Side side;
  int body;
};

bool reaches(const Side& side, Real from, Real to)
{
  return std::min(side.a[0], side.b[0]) <= from && std::max(side.a[0], side.b[0]) >= to;
}

/// From the highest in the middle between two breaks down.
void sort_by_height(std::vector<BodySide>& sides, Real from, Real to)
{
  const Real middle = 0.5 * (from + to);
  std::ranges::stable_sort(sides, std::ranges::greater(), [&](const BodySide& s) { return height_at(s.side, middle); });
}

/// Whether sides that are sorted in the middle have another order at one of the ends.
bool are_crossing(const std::vector<BodySide>& sorted, Real from, Real to)
{
  for (std::size_t k = 1; k < sorted.size(); ++k)
    for (const Real x : {from, to})
      if (height_at(sorted[k].side, x) > height_at(sorted[k - 1].side, x) + together) return true;
  return false;
}

/// Where two of the sides cross between two breaks.
std::vector<Real> crossings_between(const std::vector<BodySide>& sides, Real from, Real to)
{
  std::vector<Real> crossings;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const Real left = height_at(sides[i].side, from) - height_at(sides[j].side, from);
      const Real right = height_at(sides[i].side, to) - height_at(sides[j].side, to);
      const Real x = from + (to - from) * left / (left - right);
      if (left * right < 0.0 && x > from && x < to) crossings.push_back(x);
    }
  return crossings;
}

void sort_out(std::vector<Real>& breaks)
{
  std::ranges::sort(breaks);
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
}

}  // namespace

DrawnColumns::DrawnColumns(const std::vector<std::vector<Side>>& bodies)
{
  std::vector<BodySide> sides;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const Side& side : bodies[b])
      if (side.a[0] != side.b[0]) sides.push_back({side, static_cast<int>(b)});
  const auto left_end = [](const BodySide& s) { return std::min(s.side.a[0], s.side.b[0]); };
  std::ranges::stable_sort(sides, std::ranges::less(), left_end);
  for (const BodySide& s : sides) breaks_.push_back(s.side.a[0]), breaks_.push_back(s.side.b[0]);
  sort_out(breaks_);

  const auto walk = [&](auto&& visit) {  // visit(sides between two breaks, the breaks)
    std::vector<BodySide> here;
    std::size_t next = 0;
    for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
      const Real from = breaks_[k], to = breaks_[k + 1];
      std::erase_if(here, [&](const BodySide& s) { return !reaches(s.side, from, to); });
      for (; next < sides.size() && left_end(sides[next]) <= from; ++next) here.push_back(sides[next]);
      sort_by_height(here, from, to);
      visit(here, from, to);
    }
  };
  std::vector<Real> crossings;
  walk([&](const std::vector<BodySide>& here, Real from, Real to) {
    if (!are_crossing(here, from, to)) return;
    for (const Real x : crossings_between(here, from, to)) crossings.push_back(x);
  });
  breaks_.insert(breaks_.end(), crossings.begin(), crossings.end());
  sort_out(breaks_);

  std::vector<char> is_there(bodies.size(), 0);
  walk([&](const std::vector<BodySide>& here, Real, Real) {
    starts_.push_back(layers_.size());
    std::ranges::fill(is_there, 0);
    for (const BodySide& s : here) {
      is_there[static_cast<std::size_t>(s.body)] ^= 1;
      const auto last = std::find(is_there.rbegin(), is_there.rend(), 1);
      layers_.push_back({s.side, static_cast<int>(is_there.rend() - last) - 1});
    }
  });
  starts_.push_back(layers_.size());
}

std::span<const DrawnLayer> DrawnColumns::at(Real x) const
{
  const auto next = std::ranges::upper_bound(breaks_, x);
  if (next == breaks_.begin() || next == breaks_.end()) return {};
  const auto k = static_cast<std::size_t>(next - breaks_.begin()) - 1;
  return std::span(layers_).subspan(starts_[k], starts_[k + 1] - starts_[k]);
}

}  // namespace terp
