#include "run/element/element_tests.hpp"

#include <cmath>

namespace terp {
namespace {

constexpr ElementTestInfo tests[] = {
    {"isotropic", "pressed alike from all sides", {Grip::driven, Grip::driven, Grip::driven, Grip::held}},
    {"oedometer", "pressed along y, no strain across", {Grip::held, Grip::driven, Grip::held, Grip::held}},
    {"triaxial", "pressed along y, constant stress across", {Grip::loaded, Grip::driven, Grip::loaded, Grip::held}},
    {"biaxial", "pressed along y in plane strain, constant stress along x",
        {Grip::loaded, Grip::driven, Grip::held, Grip::held}},
    {"shear", "sheared along x, constant stress along y, no other strain",
        {Grip::held, Grip::loaded, Grip::held, Grip::driven}},
};

}  // namespace

std::span<const ElementTestInfo> element_tests() { return tests; }

ElementPath path_of_test(const ElementTestOptions& options)
{
  const bool by_strain = options.load.empty();
  const std::vector<Real>& points = by_strain ? options.strain : options.load;
  const auto grips = options.test->grips;
  const bool shears = grips[3] == Grip::driven;
  // Compression is negative in Terp; the shear angle is twice the tensorial shear strain.
  const Real factor = !shears ? -1.0 : by_strain ? 0.5 : 1.0;
  const Real start = by_strain ? 0.0 : factor * options.stress[shears ? 3 : 1];
  Real distance = 0.0, last = start;
  for (const Real point : points) distance += std::abs(point - last), last = point;
  ElementPath path{.stress = options.stress, .undrained = options.undrained};
  last = start;
  for (const Real point : points) {
    ElementLeg leg{.increments = options.increments};
    for (int k = 0; k < 4; ++k) {
      const bool is_driven = grips[k] == Grip::driven;
      const bool is_strain = is_driven ? by_strain : grips[k] == Grip::held;
      leg.control[k] = is_strain ? Control::strain : Control::stress;
      leg.target[k] = is_driven ? factor * point : is_strain ? 0.0 : options.stress[k];
    }
    leg.duration = distance > 0.0 ? options.duration * std::abs(point - last) / distance : options.duration;
    last = point;
    path.legs.push_back(leg);
  }
  return path;
}

}  // namespace terp
