// A law in a shared library as the user describes it, in plain numbers and words.
// Not for: the law (user_law.hpp).
#pragma once

#include "math/types.hpp"

#include <limits>
#include <string>
#include <vector>

namespace terp {

/// How the functions of a library are called: the entries of the table in interfaces.cpp, in their order.
enum class LawInterface { native, umat, esm, udsm };

/// Whether the law sets the state of a point in the first call for it.
constexpr bool sets_state_in_first_call(LawInterface interface)
{
  return interface == LawInterface::esm || interface == LawInterface::udsm;
}

struct NamedNumber {
  std::string name;  ///< empty: it has none
  Real value = 0.0;
};

struct LibraryCase {
  std::string file = {};  ///< relative to the case file
  LawInterface interface = LawInterface::native;
  std::string symbol = {};                   ///< empty: the usual one of the interface
  Index model_number = 1;                    ///< of a UDSM: which law of the library
  std::vector<NamedNumber> parameters = {};  ///< what the library is given, in this order
  std::vector<NamedNumber> state = {};  ///< names and values at t = 0; of a native library: values that replace its own
  std::vector<std::string> kinematics = {};  ///< of `strain`, `deformation_gradient`: kept for laws that look at them
  Real stress_unit = 1.0;                    ///< in which the library has its stresses [Pa]
  Real porosity = std::numeric_limits<Real>::quiet_NaN();  ///< that an ESM is told [-]; NaN: not given
  bool thread_safe = false;                                ///< several threads may call it at the same time
};

}  // namespace terp
