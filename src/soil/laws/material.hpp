// What a constitutive model is to the rest of Terp: two small tables and one update over arrays.
// Not for: any particular law (one file each), nor for where the arrays come from (the schemes).
#pragma once

#include "math/tensor.hpp"
#include "soil/row_table.hpp"

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// Closed or open interval of allowed values.
struct Range {
  Real low = -std::numeric_limits<Real>::infinity();
  Real high = std::numeric_limits<Real>::infinity();
  bool low_open = false;
  bool high_open = false;
  constexpr bool contains(Real value) const
  {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);  // false for NaN
  }
};
inline constexpr Range any_number{};
inline constexpr Range positive{0.0, std::numeric_limits<Real>::infinity(), true, false};
inline constexpr Range not_negative{0.0, std::numeric_limits<Real>::infinity(), false, false};
constexpr Range between_open(Real low, Real high) { return {low, high, true, true}; }
constexpr Range between(Real low, Real high) { return {low, high, false, false}; }

/// What `terp stability` does to a parameter at a factor F: nothing, p / F, atan(tan(p) / F) of an angle in degrees, or
/// 0 at any F, of strength that only fast shearing gives: a slope that stands is at rest.
enum class Reduction { none, divide, divide_tangent, zero };
constexpr bool is_strength(Reduction r) { return r == Reduction::divide || r == Reduction::divide_tangent; }
/// A strength at a factor; other parameters as they are.
Real reduced(Reduction reduction, Real value, Real factor);

/// Another way to give a parameter: by its ratio to another one of the law, as su_residual = su_peak / sensitivity.
struct RatioInfo {
  std::string_view name = {};  ///< of its key; empty: there is none
  std::string_view of = {};    ///< name of the other parameter
  bool divides = false;        ///< the parameter is the other one over the ratio; else times the ratio
  Range range = any_number;
  Range usual = any_number;
  std::string_view meaning = {};
};

/// One number that the case file gives to a law.
struct ParameterInfo {
  std::string_view name;
  std::string_view unit;  ///< "-" if it has none
  Range range;
  Real typical = std::numeric_limits<Real>::quiet_NaN();  ///< of a soil that has all that the law knows; must be given
  std::string_view meaning;
  std::optional<Real> fallback = {};  ///< default; none: the key must be given
  std::string_view fallback_of = {};  ///< name of an earlier parameter whose value is the default
  std::string_view acts_with = {};    ///< name of a parameter that must differ from its default, or this does nothing
  Range usual = any_number;           ///< outside: warn of a wrong order of magnitude
  Reduction reduction = Reduction::none;  ///< of a strength
  /// The same stresses at strains s times smaller, in times sqrt(s) times shorter, take p s^strain_exponent: 1 of a
  /// stiffness and of softening per strain, 1/2 of a viscosity, -1/2 of a strain rate. `terp stability` keeps
  /// displacements small by it (decision 0035).
  Real strain_exponent = 0.0;
  bool may_vary = false;  ///< from point to point
  RatioInfo ratio = {};   ///< may be given instead
};

/// Softening per strain: what a law's strength falls by is a function of this times the plastic strain.
constexpr bool is_shape_factor(const ParameterInfo& info) { return info.unit == "-" && info.strain_exponent == 1.0; }

/// What a quantity is to the rest of the program, whatever the law calls it: the measure of how far the soil has
/// sheared plastically, and the strength that it has left.
/// softening: the strain that drives the strength, where that is not the plastic strain itself (nonlocal.hpp).
/// carried_pressure: the largest pressure that the soil was loaded to [Pa]; of a state variable, ln of it over that at
/// the start. It stays where a stage changes the soil.
/// opening: volume strain of soil that has come apart, which no strength follows.
enum class Role { none, plastic_strain, strength, softening, carried_pressure, opening };

/// One history variable of a law, kept at the material points and in checkpoints.
struct StateInfo {
  std::string_view name;
  std::string_view unit;
  Averaging averaging;
  std::string_view meaning;
  Role role = Role::none;
  Real initial = 0.0;    ///< at t = 0
  bool scratch = false;  ///< every step writes it before it is read: neither shown nor saved
  bool shown = true;     ///< in frames, unless it is scratch
};

/// A field that results show and that follows from the state, e.g. the current strength.
struct DerivedInfo {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  Role role = Role::none;
};

/// Number of the entry of a table with a role; -1: none.
constexpr int find_role(auto infos, Role role)
{
  for (std::size_t k = 0; k < infos.size(); ++k)
    if (infos[k].role == role) return static_cast<int>(k);
  return -1;
}

/// What the points carry for a law: its state variables in the order of its table, and those of its parameters that
/// vary from point to point, in the order of its table too.
struct LawRows {
  RowView state, parameters;
};

/// What soil stores where there is water: drained soil effective stress, undrained soil total stress;
/// undrained_effective: effective stress, and beside it the excess pressure of the pore water that cannot leave.
/// by_law: total stress where the law knows no other (MaterialType::total_stress), else effective.
enum class Drainage { by_law, drained, undrained, undrained_effective };

/// Where the entries of a call of Material::update are, and what moves them: of laws that are
/// MaterialType::looks_around.
template <int Dim>
struct Surroundings {
  Real time = 0.0;                        ///< at the start of the step [s]
  std::int64_t step = 0;                  ///< number of the step, from 0
  std::span<const Index> cells = {};      ///< entry i lies in cells[i % size]; -1: it stands for no soil
  std::span<const Real> cell_sizes = {};  ///< sqrt(V_e), in the order of `cells` [m]
  std::array<const Real*, Dim> x = {};    ///< places, of each entry [m]
  const Real* d_spin = nullptr;           ///< spin of the step, of each entry, positive counter-clockwise [-]
  bool turned = false;                    ///< whether sigma has been turned by d_spin
  const Real* id = nullptr;               ///< numbers of the material points; nullptr: the entries are Gauss points
};

/// The arrays of one call of Material::update, each of n entries, n a multiple of pack_width.
template <int Dim>
struct StressArrays {
  std::array<Real*, n_sym<Dim>> sigma;        ///< in: stress at the start of the step [Pa]; out: at its end
  LawRows law;                                ///< state: in, out; parameters: in
  std::array<const Real*, n_sym<Dim>> d_eps;  ///< strain increment of the step, tensorial shear [-]
  const Real* softening_scale = nullptr;      ///< h/t_ref of each entry [-]; of laws that are MaterialType::scaled
  Real* plastic_work;                         ///< out: plastic or viscous work of the step per volume [J/m^3]
  Index n;
  Index n_points;          ///< of the n entries; those beyond are padding, which has no parameters of its own
  Real dt;                 ///< length of the step [s]
  Real at_strength = 1.0;  ///< strengths are those of the parameters divided by this [-]
  const Surroundings<Dim>* around = nullptr;  ///< of laws that look around
};

/// How softening in a material spreads over a distance: the keys of [material.NAME.softening].
struct SofteningOptions {
  Real length = 0.0;         ///< l [m]; 0: each point softens by its own plastic strain alone
  Real over_nonlocal = 1.5;  ///< m, weight of the nonlocal strain [-]
  bool halo = true;          ///< soil beside a band may soften; false: only by what it sheared itself

  Real reference_width = 0.0;  ///< t_ref: width of the band for which the shape factors hold [m]; 0: of any

  bool is_nonlocal() const { return length > 0.0; }
  bool is_scaled() const { return reference_width > 0.0; }
  /// What the nonlocal strain counts: the width of its band over t_ref [-]. The band is 1.77 l wide with m = 1, the
  /// integral of exp(-r^2/l^2), and 3.07 l with m = 1.5 (decision 0046).
  Real band_scale() const
  {
    return is_scaled() ? (over_nonlocal == 1.0 ? 1.77 : 3.07) * length / reference_width : 1.0;
  }
};

/// The arrays of one call of Material::soften, each of n entries, n a multiple of pack_width.
struct SofteningArrays {
  LawRows law;         ///< state: in, out; parameters: in
  const Real* spread;  ///< the increments of the step as they come from all around, in parts of softened_strain() [-]
  Index n;
  Index n_points;  ///< as in StressArrays
};

/// Elastic moduli [Pa].
struct Moduli {
  Real bulk, shear;
  Real p_wave() const { return bulk + 4.0 / 3.0 * shear; }  ///< K + 4G/3
};

/// What is wrong with a set of parameters that are each in range.
struct ParameterProblem {
  std::string parameter, what, detail;
};

/// A law with its parameters. `at` is one point: pointers to its numbers.
class Material {
 public:
  virtual ~Material() = default;
  virtual void update(const StressArrays<2>& arrays) const = 0;
  /// Renews what drives the strength of the next step. Of laws that are MaterialType::nonlocal; others do nothing.
  virtual void soften(const SofteningOptions& options, const SofteningArrays& arrays) const = 0;
  virtual Moduli moduli(const LawRows& at) const = 0;  ///< of the stiffest state, where they follow the stress
  virtual Moduli moduli_at(const LawRows& at, const SymTensor<Real, 2>&) const { return moduli(at); }
  /// Elastic energy per volume [J/m^3]. Of laws that are MaterialType::stiffness_by_stress; p^2/2K + s:s/4G of others.
  virtual Real stored_energy(const LawRows&, const SymTensor<Real, 2>&) const { return 0.0; }
  /// 1/(2K) of the next pack_width points [1/Pa]: times p^2 it is what a pressure stores. n_points: of them that are
  /// none of padding. Of laws whose parameters vary.
  virtual void half_compliance(const LawRows&, [[maybe_unused]] Index n_points, Real*) const {}
  /// Why a stress cannot be that of t = 0; of laws whose strength follows the stress.
  virtual std::vector<ParameterProblem> check_start(const LawRows&, const SymTensor<Real, 2>&) const { return {}; }
  /// Makes the state one that admits the stress, which a search for equilibrium found.
  virtual void start(const LawRows&, const SymTensor<Real, 2>&) const {}
  virtual Real viscosity(const LawRows& at) const = 0;  ///< mu [Pa s], for the time step; 0 where the stress knows none
  /// Value of derived field k (order of MaterialType::derived).
  virtual Real derived(int k, const LawRows& at) const = 0;
  /// Plastic strain at which softening has taken 95 % of what it can take [-]; infinite where nothing softens.
  virtual Real softened_strain() const = 0;
  /// Numbers of the parameters that vary from point to point; those of a point are in LawRows::parameters.
  virtual std::span<const int> varying() const = 0;
  /// What went wrong in a law that can fail, in words for the user; empty: nothing.
  virtual std::string fault() const { return {}; }

  // Of the parameters that are the same for all points, and of the reference values of those that vary.
  virtual Moduli moduli() const = 0;
  Real bulk_modulus() const { return moduli().bulk; }
  Real shear_modulus() const { return moduli().shear; }
  Real p_wave_modulus() const { return moduli().p_wave(); }
  virtual Real viscosity() const = 0;
};

/// A law without its parameters: what materials.def lists.
struct MaterialType {
  std::string_view name;
  std::string_view summary;
  std::string_view equations;  ///< lines of text for `terp explain`
  std::span<const ParameterInfo> parameters;
  std::span<const StateInfo> state;
  std::span<const DerivedInfo> derived;
  bool total_stress;            ///< its strength is one of total stress, or it is a fluid: never drained
  bool ignores_pressure;        ///< its strength, if it has one, does not follow the mean stress
  bool depends_on_rate;         ///< the stress at the end of a step depends on its length
  bool stiffness_by_stress;     ///< its elastic moduli follow the stress; Material::moduli() are the largest
  std::string_view not_judged;  ///< why `terp stability` may not judge soil of this law; empty: it may
  bool by_library;              ///< its update, its state and some of its parameters come from a library of the user
  bool looks_around;            ///< its update needs StressArrays::around
  /// values: one per entry of `parameters`, in that order, each in its range.
  std::vector<ParameterProblem> (*check)(std::span<const Real> values);
  std::unique_ptr<Material> (*maker)(
      const MaterialType& type, std::span<const Real> values, std::span<const int> varying);

  /// The same law with a strength that follows a nonlocal strain (nonlocal.hpp); nullptr: the law does not soften.
  const MaterialType* nonlocal;
  /// The same law with a strength that follows a plastic strain scaled by the cell (scaled_softening.hpp), or nullptr.
  const MaterialType* scaled;
  /// The same law with a limit of tension that acts, and the opening that it takes (tension.hpp); nullptr: the law has
  /// no such limit, or remembers an opening in any case.
  const MaterialType* torn;

  /// varying: ascending numbers of the parameters that the points bring with them.
  std::unique_ptr<Material> make_varying(std::span<const Real> values, std::span<const int> varying) const
  {
    return maker(*this, values, varying);
  }
  std::unique_ptr<Material> make(std::span<const Real> values) const { return make_varying(values, {}); }
  /// Values of all parameters: those left out, being no number or beyond the end, at their defaults if they have any.
  std::vector<Real> complete(std::span<const Real> given) const;
};

/// The parameter that limits tension, in all laws that have one (tension.hpp).
inline constexpr std::string_view tension_cutoff = "tension_cutoff";

/// Every law in this build, in the order of materials.def, compiled for this processor (material_list.hpp).
std::span<const MaterialType* const> all_materials();
/// nullptr if there is no such law.
const MaterialType* find_material(std::string_view name);
/// With these options of softening, and where a limit of tension acts: the law itself, or the form of it that they ask
/// for.
const MaterialType* find_material(std::string_view name, const SofteningOptions& softening, bool tears = false);

}  // namespace terp
