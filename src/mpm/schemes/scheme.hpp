// What a scheme is to the rest of Terp: its properties, and two functions over a group of cells.
// Not for: what a scheme computes (one file each beside this one, listed in schemes.def).
#pragma once

#include "mpm/kernels/cell_sums.hpp"
#include "mpm/kernels/method_options.hpp"

#include <span>
#include <string_view>

namespace terp {

struct SchemeContext;
struct StressSums;
template <class Element>
struct CellGroup;

/// Floating-point operations and memory traffic of one point in one pass, counted from the kernels by hand.
struct PassCost {
  double flops = 0.0;  ///< a multiply-add counts two; of an elastic point
  double rows = 0.0;   ///< of a block, each once per pass where it is read and once where it is written
  double bytes() const { return rows * sizeof(Real); }
};

/// A scheme over groups of cells, in the order in which the step calls it: all groups pass one function before the next
/// begins. Those that are nullptr are not needed.
struct SchemeFunctions {
  /// Turns the points of a group into their Gauss values and adds the internal force to group.corners. With shares that
  /// overlap it ends with sums over the patches of the cells, and `integrate` does the rest.
  void (*gather)(const SchemeContext& context, const CellGroup<Quad4>& group) = nullptr;
  void (*integrate)(const SchemeContext& context, const CellGroup<Quad4>& group) = nullptr;
  /// What the points of other cells need from this group before `update_stress`.
  void (*strain)(const SchemeContext& context, const CellGroup<Quad4>& group, const GroupVectors<Quad4>& du,
      StressSums& sums) = nullptr;
  /// Turns displacements of the corners of each cell, du [m], into new stress, state, strain and volume of the points,
  /// and adds their plastic work to `sums`.
  void (*update_stress)(const SchemeContext& context, const CellGroup<Quad4>& group, const GroupVectors<Quad4>& du,
      StressSums& sums) = nullptr;
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

  SchemeFunctions overlap = {};  ///< with shares that overlap; empty: the scheme does not look at them
  SchemeFunctions point;

  const SchemeFunctions& functions(Shares shares) const
  {
    return shares == Shares::overlap && overlap.gather != nullptr ? overlap : point;
  }
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

/// Last lines of a scheme's file, in namespace terp: the properties of the scheme NAME, whose functions are static
/// members of Struct<Element>; schemes.def lists it.
#define TERP_SCHEME_DEFINITION(NAME, Struct, ...)     \
  extern const Scheme scheme_##NAME;                  \
  constinit const Scheme scheme_##NAME{.name = #NAME, \
      __VA_ARGS__,                                    \
      .point = {.gather = &Struct<Quad4>::gather, .update_stress = &Struct<Quad4>::update_stress}};

/// The same for shares that overlap, among the properties of a scheme.
#define TERP_OVERLAP_FUNCTIONS(Struct)                \
  .overlap = {.gather = &Struct<Quad4>::sum_patches,  \
      .integrate = &Struct<Quad4>::integrate_patches, \
      .strain = &Struct<Quad4>::leave_strain,         \
      .update_stress = &Struct<Quad4>::update_from_patches}
