#include "run/measure/settled_ground.hpp"

#include "mpm/step/stage.hpp"

#include <algorithm>
#include <array>

namespace terp {
namespace {

constexpr Real part_of_cell = 0.012;   // by which the height of a drawn dike on cells of 0.5 m is at most off: 0.006 m
constexpr Real scarp = 3.0;            // metres of width for one of height
constexpr Real part_of_volume = 0.01;  // half of what cells of half the width change in cases/dike
constexpr auto numbers = std::array{&GroundLeft::height, &GroundLeft::width, &GroundLeft::moved};

}  // namespace

GroundLeft resolution_of(const GroundLeft& ground, Real cell_width)
{
  const Real height = part_of_cell * cell_width;
  return {height, scarp * height, std::max(part_of_volume * ground.moved, cell_width * cell_width)};
}

bool SettledGround::enter(const GroundLeft& ground, const GroundLeft& resolution)
{
  looks_.push_back(ground);
  constexpr std::size_t n = RestMarks::n + 1;
  if (looks_.size() > n) looks_.erase(looks_.begin());
  return looks_.size() == n && std::ranges::all_of(numbers, [&](Real GroundLeft::*number) {
    const auto [low, high] = std::ranges::minmax(looks_, {}, number);
    return low.*number == high.*number || high.*number - low.*number < resolution.*number;
  });
}

std::vector<Real> SettledGround::values() const
{
  std::vector<Real> values;
  for (const GroundLeft& look : looks_)
    for (Real GroundLeft::*number : numbers) values.push_back(look.*number);
  return values;
}

void SettledGround::set_values(const std::vector<Real>& values)
{
  looks_.assign(values.size() / numbers.size(), {});
  for (std::size_t k = 0; k < looks_.size() * numbers.size(); ++k)
    looks_[k / numbers.size()].*numbers[k % numbers.size()] = values[k];
}

}  // namespace terp
