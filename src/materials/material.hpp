// What a constitutive model is to the rest of Terp: two small tables and one update over arrays.
// Not for: any particular law (one file each), nor for where the arrays come from (the schemes).
#pragma once

#include "base/types.hpp"

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// Most state variables that one law may have.
inline constexpr int max_state = 4;

/// Closed or open interval of allowed values.
struct Range {
  Real low = -std::numeric_limits<Real>::infinity();
  Real high = std::numeric_limits<Real>::infinity();
  bool low_open = false;
  bool high_open = false;
  bool contains(Real value) const
  {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);  // false for NaN
  }
};
inline constexpr Range any_number{};
inline constexpr Range positive{0.0, std::numeric_limits<Real>::infinity(), true, false};
inline constexpr Range not_negative{0.0, std::numeric_limits<Real>::infinity(), false, false};
constexpr Range between_open(Real low, Real high) { return {low, high, true, true}; }
constexpr Range between(Real low, Real high) { return {low, high, false, false}; }

/// What `terp stability` does to a parameter at a factor F: nothing, p / F, or atan(tan(p) / F) of an angle in degrees.
enum class Reduction { none, divide, divide_tangent };

/// What makes all strains s times smaller at the same stresses, in times that are sqrt(s) shorter: nothing, p s
/// (stiffness, softening per strain), or p sqrt(s) (viscosity). `terp stability` keeps displacements small by it
/// (decision 0035).
enum class StrainScale { none, multiply, multiply_root };

/// One number that the case file gives to a law.
struct ParameterInfo {
  std::string_view name;
  std::string_view unit;  ///< "-" if it has none
  Range range;
  std::string_view meaning;
  std::optional<Real> fallback = {};             ///< default; none: the key must be given
  Range usual = any_number;                      ///< outside: warn of a wrong order of magnitude
  std::string_view fallback_of = {};             ///< name of an earlier parameter whose value is the default
  Reduction reduction = Reduction::none;         ///< of a strength
  StrainScale strain_scale = StrainScale::none;  ///< of a stiffness, a viscosity, and what a strain is compared with
};

/// How MPM-Mixed averages a state variable (reading R9).
enum class Averaging { cell, sub_cell };

/// What a quantity is to the rest of the program, whatever the law calls it: the measure of how far the soil has
/// sheared plastically, and the strength that it has left.
enum class Role { none, plastic_strain, strength };

/// One history variable of a law, kept at the material points and in checkpoints.
struct StateInfo {
  std::string_view name;
  std::string_view unit;
  Averaging averaging;
  std::string_view meaning;
  Role role = Role::none;
};

/// A field that results show and that follows from the state, e.g. the current strength.
struct DerivedInfo {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  Role role = Role::none;
};

/// Number of the entry of a table with a role; -1: none.
int find_role(auto infos, Role role)
{
  for (std::size_t k = 0; k < infos.size(); ++k)
    if (infos[k].role == role) return static_cast<int>(k);
  return -1;
}

/// The arrays of one call of Material::update, each of n entries, n a multiple of pack_width.
template <int Dim>
struct StressArrays {
  std::array<Real*, n_sym<Dim>> sigma;        ///< in: stress at the start of the step [Pa]; out: at its end
  std::array<Real*, max_state> state;         ///< in, out: state variables in the order of the law's table
  std::array<const Real*, n_sym<Dim>> d_eps;  ///< strain increment of the step, tensorial shear [-]
  Real* plastic_work;                         ///< out: plastic or viscous work of the step per volume [J/m^3]
  Index n;
  Real dt;  ///< length of the step [s]
};

/// A law with its parameters.
class Material {
 public:
  virtual ~Material() = default;
  virtual void update(const StressArrays<2>& arrays) const = 0;
  virtual Real bulk_modulus() const = 0;   ///< K [Pa]
  virtual Real shear_modulus() const = 0;  ///< G [Pa]; 0 of a fluid
  virtual Real viscosity() const = 0;      ///< mu [Pa s], for the time step; 0 where the law knows no rate
  /// Value of derived field k (order of MaterialType::derived) for one point. state: shape [n_state].
  virtual Real derived(int k, const Real* state) const = 0;

  Real p_wave_modulus() const { return bulk_modulus() + 4.0 / 3.0 * shear_modulus(); }  ///< K + 4G/3 [Pa]
};

/// What is wrong with a set of parameters that are each in range.
struct ParameterProblem {
  std::string parameter, what, detail;
};

/// A law without its parameters: what materials.def lists.
struct MaterialType {
  std::string_view name;
  std::string_view summary;
  std::string_view equations;  ///< lines of text for `terp explain`
  std::span<const ParameterInfo> parameters;
  std::span<const StateInfo> state;
  std::span<const DerivedInfo> derived;
  /// values: one per entry of `parameters`, in that order, each in its range.
  std::vector<ParameterProblem> (*check)(std::span<const Real> values);
  std::unique_ptr<Material> (*make)(std::span<const Real> values);
};

/// Every law in this build, in the order of materials.def, compiled for this processor (parallel/kernels.hpp).
std::span<const MaterialType* const> all_materials();
/// nullptr if there is no such law.
const MaterialType* find_material(std::string_view name);

}  // namespace terp
