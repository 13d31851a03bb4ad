// What a scheme is to the rest of Terp: its properties, where stress lives, and its kernels of the score.
// Not for: what a scheme computes (one file each beside this one, listed in schemes.def).
#pragma once

#include "mpm/kernels/cell_sums.hpp"
#include "mpm/kernels/method_options.hpp"
#include "mpm/step/score.hpp"

#include <span>
#include <string_view>

namespace terp {

/// Floating-point operations and memory traffic of one point in one pass, counted from the kernels by hand.
struct PassCost {
  double flops = 0.0;  ///< a multiply-add counts two; of an elastic point
  double rows = 0.0;   ///< of a block, each once per pass where it is read and once where it is written
  double bytes() const { return rows * sizeof(Real); }
};

struct Scheme {
  std::string_view name;                 ///< as in the case file: "mpm_gp"
  std::string_view title;                ///< as in a text: "MPM-GP"
  std::string_view summary;              ///< one line
  std::string_view unused_options = {};  ///< names in [method] that it does not look at, separated by blanks
  std::string_view with_overlap =
      {};                           ///< in what it is not the paper's with shares that overlap; empty: in shares alone
  bool locks = false;               ///< in nearly incompressible soil: a factor of safety would be far too large
  bool keeps_gauss_values = false;  ///< from gather to update_stress, of every material in every cell
  PassCost gather_cost, stress_cost;

  /// Its kernels (mpm/step/score.hpp), and where stress lives: with a share of a point in its own sub-cell alone, and
  /// in those of the cells around; empty: the scheme does not look at them.
  std::span<const Kernel> own_shares, patches = {};
  StressHome home_of_own_shares, home_of_patches = patched_cells;

  bool uses_patches(Shares shares) const { return shares == Shares::overlap && !patches.empty(); }
  std::span<const Kernel> kernels(Shares shares) const { return uses_patches(shares) ? patches : own_shares; }
  StressHome home(Shares shares) const { return uses_patches(shares) ? home_of_patches : home_of_own_shares; }
};

/// Schemes in the order of schemes.def.
using SchemeList = std::span<const Scheme* const>;

/// Every scheme in this build, compiled for set number `set` of instruction_sets() (os/instructions.hpp).
SchemeList schemes_of_set(std::size_t set);
/// The same, compiled for this processor.
SchemeList all_schemes();
/// nullptr if there is no such scheme.
const Scheme* find_scheme(std::string_view name);

/// Whether an option of [method] changes anything with this scheme.
bool looks_at(const Scheme& scheme, std::string_view option);

}  // namespace terp

/// Last lines of a scheme's file, in namespace terp: the properties of the scheme NAME; schemes.def lists it.
#define TERP_SCHEME_DEFINITION(NAME, ...) \
  extern const Scheme scheme_##NAME;      \
  constinit const Scheme scheme_##NAME{.name = #NAME, __VA_ARGS__};
