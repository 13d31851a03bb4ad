// A law that reads beyond its arrays gets what happens to lie there. So the same path is run with different numbers
// behind the arrays, and the ends are compared to the bit. A law that does not repeat itself on equal numbers tells
// nothing on that path. Each run makes the law anew: one that fails once stays failed.

#include "model/libraries/short_arrays.hpp"

#include "model/libraries/law_trial.hpp"
#include "soil/libraries/library_material.hpp"

#include <bit>
#include <cstring>

namespace terp {
namespace {

/// Equal strain increments, one after the other. Their size is that of the steps of soil that fails; the shear strain
/// in the end, 2 %, is beyond the yield of soil with G > 50 times its strength.
struct TrialPath {
  std::array<Real, 4> d_eps;  ///< xx yy zz xy, tensorial shear
  int n;
};
constexpr Real trial_increment = 5e-4;
constexpr TrialPath trial_paths[] = {
    {{0.0, 0.0, 0.0, trial_increment}, 20},  // shear
    {{0.0, -trial_increment, 0.0, 0.0}, 10},
    {{0.0, trial_increment, 0.0, 0.0}, 4},
};

/// What a parameter may be: nothing, a switch that is on, and beyond all that it may be compared with.
constexpr Real trial_numbers[] = {0.0, 1.0, 1e30, -1e30};

struct PathEnd {
  std::vector<Real> numbers;  ///< stress and state
  std::string fault;
  bool operator==(const PathEnd& other) const  // to the bit: NaN is equal to itself
  {
    return fault == other.fault && numbers.size() == other.numbers.size() &&
           std::memcmp(numbers.data(), other.numbers.data(), numbers.size() * sizeof(Real)) == 0;
  }
};

}  // namespace

std::string_view find_short_array(
    const SoilMaterial& material, std::span<const Real> values, const PointBlock<2>& block, Real cell_size, Real dt)
{
  const auto end_of = [&](const TrialPath& path, const NumbersBeyond& beyond) {
    SoilMaterial with_beyond = material;
    std::unique_ptr<Material> law = material.type->make(values);
    static_cast<LibraryMaterial&>(*law).put_beyond(beyond);
    with_beyond.law = std::move(law);
    LawTrial trial(with_beyond, block, cell_size, dt);
    trial.prepare(path.d_eps);
    for (int k = 0; k < path.n && with_beyond.law->fault().empty(); ++k) trial.call();
    return PathEnd{trial.stress_and_state(), with_beyond.law->fault()};
  };
  for (const TrialPath& path : trial_paths) {
    const PathEnd usual = end_of(path, {});
    if (!(end_of(path, {}) == usual)) continue;
    for (const Real number : trial_numbers) {
      const auto bits = std::bit_cast<std::uint64_t>(number);
      if (!(end_of(path, {.parameters = bits}) == usual)) return "parameters";
      if (!(end_of(path, {.state = bits}) == usual)) return "state";
    }
  }
  return {};
}

}  // namespace terp
