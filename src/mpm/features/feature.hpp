// What the step calls of a feature without knowing which it is. A new feature is a file here and a line of
// features.def. Not for: its kernels (mpm/step/score.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace terp {

struct StepModel;
struct StepState;
struct Workspace;
struct OuterForces;
class ArrayWriter;
class ArrayReader;

/// Members may be left out.
struct Feature {
  std::string_view name;  ///< of its slots
  /// Room for its arrays as cells fill or empty: at the start for twice as much (fit_array).
  void (*fit)(const StepModel&, const StepState&, Workspace&) = nullptr;
  /// Its part of a checkpoint, under names of its own.
  void (*save)(const StepState&, ArrayWriter&) = nullptr;
  /// The same back, into a state that has all but the features. Throws FileError if an array does not fit.
  void (*load)(const StepModel&, const ArrayReader&, StepState&) = nullptr;
};

/// In the order of features.def.
std::span<const Feature* const> all_features();

/// Sets the size of an array; when it first gets room, room for twice that: steps ask for no memory until the soil has
/// spread that far.
void fit_array(std::size_t size, auto& array)
{
  if (array.capacity() == 0) array.reserve(2 * size);
  array.resize(size);
}

/// Room for forces from outside on the nodes and on the corners of the occupied cells.
void fit_outer(const StepModel& model, const StepState& state, OuterForces& outer);
void fit_outer_nodes(const StepModel& model, OuterForces& outer);

}  // namespace terp

/// Last line of a feature's file, in namespace terp; features.def lists it.
#define TERP_FEATURE_DEFINITION(NAME, ...) \
  extern const Feature feature_##NAME;     \
  constinit const Feature feature_##NAME{.name = #NAME __VA_OPT__(, ) __VA_ARGS__};
