// How Terp calls the functions of a library, one file for each way (umat.cpp, native.cpp), and the table of all ways.
// Not for: what Terp's kernels see of the law (user_law.hpp).
#pragma once

#include "os/shared_library.hpp"
#include "soil/libraries/library_case.hpp"

#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// Points that one call takes at most.
inline constexpr int most_points_of_call = 64;

/// What stands behind the arrays of a library, as bits of a number: a law that reads it was given too little, one that
/// writes there stops the run.
struct NumbersBeyond {
  static constexpr std::uint64_t none = 0x7ff0'5465'7270'4c61;  ///< a signalling NaN: a sum with it is another
  std::uint64_t parameters = none, state = none;
  bool operator==(const NumbersBeyond&) const = default;
};
inline constexpr std::size_t n_numbers_beyond = 128;  ///< more than the numbers of state that a case may give

/// Points of soil on their way to a library: arrays of n numbers. Rows of the state: those of the law, then what is
/// kept for it (LibraryCase::kinematics): strain 11 22 33 12, tensorial shear; deformation gradient 11 12 21 22 33;
/// of an ESM whether it was called. Stresses are in the unit of the library.
struct LawPoints {
  template <class T>
  using Row = std::array<T, most_points_of_call>;

  int n = 0;
  Real time = 0.0;  ///< at the start of the step [s]
  Real dt = 0.0;    ///< [s]
  std::int64_t step = 0;
  std::array<Row<Real>, 4> sigma;  ///< [LibraryCase::stress_unit]
  std::array<Row<Real>, 4> d_eps;  ///< [-]
  Row<Real> d_spin;                ///< [-]
  bool turned = false;             ///< whether sigma has been turned by d_spin
  std::array<Row<Real>, 2> x;      ///< [m]
  Row<Real> cell_size;             ///< [m]
  Row<Index> cell;                 ///< -1: not known
  Row<std::int64_t> id;            ///< of the material point, or of the Gauss point of the cell
  bool of_gauss_points = false;
  std::vector<Real*> state;   ///< rows
  std::vector<Real> scratch;  ///< for the interface: LawCalls::n_scratch numbers
  NumbersBeyond beyond;

  /// What the interface reports: where it is, and why it stopped there.
  static constexpr int unknown = -1;
  int at = unknown;  ///< number of the point
  bool failed = false;
  const char* cure = nullptr;  ///< what may help, in words; nullptr: to look into the law
  std::array<char, 256> why{};

  bool is_at_a_point() const { return at >= 0 && at < n; }
  template <class... Values>
  void fail(fmt::format_string<Values...> words, Values&&... values)
  {
    failed = true;
    *fmt::format_to_n(why.data(), why.size() - 1, words, std::forward<Values>(values)...).out = '\0';
  }
};

/// The smallest part of a step that a law may ask for, and what helps where it asks for less.
inline constexpr Real smallest_part = 1.0 / 4096.0;
inline constexpr const char* smaller_steps = "a lower time.courant, or a law that takes larger increments";

/// A library with its parameters, as it is called.
class LawCalls {
 public:
  virtual ~LawCalls() = default;
  /// New stress and state of all points; stops at one that fails.
  virtual void run(LawPoints& points) const = 0;
  virtual std::size_t n_scratch() const { return 0; }
};

/// What a library says of itself.
struct LawVariables {
  struct Variable {
    std::string name, unit, meaning;
    Real initial = 0.0;
  };
  std::vector<Variable> parameters;
  std::vector<Variable> state;
  bool thread_safe = false;
};

/// n_components: of stress and strain, 4 or 6; a native library has 4.
using MakeLaw = std::unique_ptr<LawCalls>(
    void* symbol, const LibraryCase& library, const std::string& material, int n_components);
MakeLaw make_native, make_umat, make_esm, make_udsm;

struct InterfaceInfo {
  std::string_view name;                            ///< in the case file: "umat"
  std::span<const std::string_view> usual_symbols;  ///< that are looked for where none is given
  std::string_view meaning;
  /// What the library says of itself; none: it cannot say anything. Throws InputError with a problem without key.
  /// A UDSM says how many state variables there are, which `library` then has.
  std::optional<LawVariables> (*describe)(void* symbol, LibraryCase& library);
  MakeLaw* make;
};

/// In the order of LawInterface.
std::span<const InterfaceInfo> law_interfaces();
inline const InterfaceInfo& info_of(LawInterface which) { return law_interfaces()[static_cast<std::size_t>(which)]; }

/// Rows that are kept for a law beyond its state, in their order.
bool keeps(const LibraryCase& library, std::string_view kinematics);
inline constexpr std::size_t n_strain_rows = 4, n_gradient_rows = 5;

}  // namespace terp
