// Paths of laboratory tests: which strain or stress of each component the apparatus holds, and what it drives.
#pragma once

#include "run/element/element.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace terp {

/// What an apparatus does to a component.
enum class Grip { held, loaded, driven };  ///< strain stays; stress stays; strain or stress goes to the turning points

struct ElementTestInfo {
  std::string_view name, meaning;
  std::array<Grip, 4> grips;  ///< xx yy zz xy
};

/// isotropic, oedometer, triaxial, biaxial, shear.
std::span<const ElementTestInfo> element_tests();

struct ElementTestOptions {
  const ElementTestInfo* test = nullptr;
  std::array<Real, 4> stress{};  ///< at the start [Pa]
  bool undrained = false;
  std::vector<Real> strain = {};  ///< turning points of what is driven: compression, or the shear angle [-]
  std::vector<Real> load = {};    ///< instead: stress, compression positive, or the shear stress [Pa]
  int increments = 1000;          ///< to each turning point
  Real duration = 1000.0;         ///< of the whole test [s]
};

/// Turning points follow each other; the time between them is as their distances.
ElementPath path_of_test(const ElementTestOptions& options);

}  // namespace terp
