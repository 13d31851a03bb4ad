// All points are made before the study begins, from counted random numbers, so no order of the workers changes them.
// Each number has its own permutation or shift. The first Sobol points stay the same when more are asked for. Those of
// a Latin hypercube change, as its strata depend on how many there are.

#include "batch/points.hpp"

#include "math/philox.hpp"

#include <boost/random/sobol.hpp>

#include <algorithm>
#include <utility>

namespace terp {
namespace {

using Points = std::vector<std::vector<Real>>;

PhiloxKey key_of(const StudySettings& s) { return {static_cast<std::uint32_t>(s.seed), 0}; }

/// For each number a permutation of the samples, by the order of counted random numbers.
Points latin_hypercube(const StudySettings& s)
{
  const auto n = static_cast<std::size_t>(s.stop.number);
  Points points(s.numbers.size(), std::vector<Real>(n));
  for (std::size_t number = 0; number < points.size(); ++number) {
    const auto uniform = [&](std::size_t k, std::uint32_t stream) {
      return philox_uniform({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(number), stream, 0}, key_of(s));
    };
    std::vector<std::pair<Real, std::size_t>> order(n);
    for (std::size_t k = 0; k < n; ++k) order[k] = {uniform(k, stream_of_strata), k};
    std::ranges::sort(order);
    for (std::size_t k = 0; k < n; ++k)
      points[number][k] = (static_cast<Real>(order[k].second) + uniform(k, stream_of_values)) / static_cast<Real>(n);
  }
  return points;
}

/// The first 52 bits of a point, with those of the shift turned over: each point is then uniform, and their evenness is
/// kept. Half a bit more keeps it between 0 and 1. Boost begins behind the point 0, without which no power of two of
/// points is even.
Points sobol(const StudySettings& s)
{
  Points points(s.numbers.size(), std::vector<Real>(static_cast<std::size_t>(s.stop.number)));
  std::vector<std::uint64_t> shift;
  for (std::size_t number = 0; number < points.size(); ++number) {
    const PhiloxCounter bits = philox({0, static_cast<std::uint32_t>(number), stream_of_shift, 0}, key_of(s));
    shift.push_back((std::uint64_t{bits[0]} << 32) | bits[1]);
  }
  boost::random::sobol sequence(points.size());
  for (std::size_t k = 0; k < points.front().size(); ++k)
    for (std::size_t number = 0; number < points.size(); ++number)
      points[number][k] = (static_cast<Real>(((k == 0 ? 0 : sequence()) ^ shift[number]) >> 12) + 0.5) * 0x1.0p-52;
  return points;
}

}  // namespace

std::size_t most_sobol_numbers() { return boost::random::default_sobol_table::max_dimension; }

std::vector<std::vector<Real>> make_points(const StudySettings& settings)
{
  if (settings.numbers.empty()) return {};
  if (settings.estimator == Estimator::latin_hypercube) return latin_hypercube(settings);
  if (settings.estimator == Estimator::sobol) return sobol(settings);
  return {};
}

}  // namespace terp
