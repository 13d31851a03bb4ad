// Turns one law, a small struct with a pointwise update, into a MaterialType: the loop over packs, the factory and the
// checks that every law shares. A law's file includes this; nobody else does.
//
// A law is a template on the number type P of its parameters. Law<Real> has the same parameters for all points, and is
// made once. Law<Pack> has those of eight points, and is made for each pack from their rows. One text serves both.
#pragma once

#include "math/errors.hpp"
#include "math/tensor.hpp"
#include "soil/laws/material.hpp"
#include "soil/laws/nonlocal.hpp"
#include "soil/laws/scaled_softening.hpp"
#include "math/pack.hpp"

#include <algorithm>
#include <optional>

namespace terp {

/// A law in the form that the rest of Terp calls.
///
/// Law<P> must have: static constexpr std::string_view `equations`; static constexpr tables `parameters`
/// (ParameterInfo[]), `state` (StateInfo[]) and `derived` (DerivedInfo[]), as std::array; `explicit Law(std::span<const
/// P>)`, the parameters in the order of the table; bulk_modulus() and shear_modulus(); template <class R, int Dim> R
/// update(SymTensor<R, Dim>& sigma, std::array<R, n>& state, const SymTensor<R, Dim>& d_eps, Real dt) const, which
/// returns the plastic or viscous work per volume [J/m^3]. P is R or Real: R(parameter) is right for both.
///
/// It may have: derived_value(k, state); check(); softened_strain(), the plastic strain at which 95 % of the softening
/// is done, of the slowest if it has several, infinite where nothing softens; viscosity(), of a stress that any strain
/// rate adds to the elastic one at once, as in a fluid: it shortens the time step; `total_stress = true` of an
/// undrained strength or a fluid; `ignores_pressure = true` of another strength that does not follow the mean stress;
/// `depends_on_rate = true` where the update looks at dt, be it viscosity or a strength
/// that the rate raises; `not_judged`, a reason why `terp stability` would give a number that is none.
///
/// Where the stiffness follows the stress, bulk_modulus() and shear_modulus() are those of the stiffest state, which
/// the time step holds for. The law then has moduli_at(sigma) and stored_energy(sigma) [J/m^3], too. Where the strength
/// follows the stress: check_start(sigma, state), problems of a stress that soil begins with, and start(sigma, state),
/// which makes the state one that admits the stress.
///
/// A law that softens also has template <class R> Law<R> softened_at(R k) const, the same law with the strengths that
/// it has at the plastic strain k, which they then keep. With that it has a nonlocal form (nonlocal.hpp).
/// check_within_point(): problems of softening in a point by itself, which a nonlocal form does not have.
template <template <class> class Law>
class MaterialOf final : public Material {
  using Uniform = Law<Real>;
  static constexpr std::size_t n_parameters = Uniform::parameters.size(), n_state = Uniform::state.size();

 public:
  MaterialOf(std::span<const Real> values, std::span<const int> varying)
      : law_(values), varying_(varying.begin(), varying.end())
  {
    TERP_ASSERT(values.size() == n_parameters);
    std::ranges::copy(values, values_.begin());
  }

  void update(const StressArrays<2>& arrays) const override
  {
    std::array<Real*, n_state> state;
    for (std::size_t k = 0; k < n_state; ++k) state[k] = arrays.law.state(k);
    const bool is_other = arrays.at_strength != 1.0;
    if (varying_.empty()) {
      std::optional<Uniform> other;
      if (is_other) other.emplace(reduced_values(arrays.at_strength));
      const Uniform& law = is_other ? *other : law_;
      for (Index p = 0; p < arrays.n; p += pack_width) update_pack(law, arrays, state, p);
      return;
    }
    for (Index p = 0; p < arrays.n; p += pack_width) {
      std::array<Pack, n_parameters> parameters = parameters_of(arrays, p);
      if (is_other) reduce_strengths(arrays.at_strength, parameters);
      update_pack(Law<Pack>(parameters), arrays, state, p);
    }
  }

  void soften(
      [[maybe_unused]] const SofteningOptions& options, [[maybe_unused]] const SofteningArrays& arrays) const override
  {
    if constexpr (requires { Uniform::softening_row; })
      for (Index p = 0; p < arrays.n; p += pack_width) {
        if (varying_.empty())
          soften_pack(law_, options, arrays, p);
        else
          soften_pack(Law<Pack>(parameters_of(arrays, p)), options, arrays, p);
      }
  }

  Moduli moduli() const override { return {law_.bulk_modulus(), law_.shear_modulus()}; }
  Moduli moduli(const LawRows& at) const override
  {
    const Uniform law = law_of(at);
    return {law.bulk_modulus(), law.shear_modulus()};
  }
  Moduli moduli_at(const LawRows& at, const SymTensor<Real, 2>& sigma) const override
  {
    if constexpr (requires { law_.moduli_at(sigma); }) return law_of(at).moduli_at(sigma);
    return moduli(at);
  }
  Real stored_energy(const LawRows& at, const SymTensor<Real, 2>& sigma) const override
  {
    if constexpr (requires { law_.stored_energy(sigma); }) return law_of(at).stored_energy(sigma);
    return 0.0;
  }
  void half_compliance(const LawRows& at, Index n_points, Real* out) const override
  {
    const struct {
      LawRows law;
      Index n_points;
    } arrays{at, n_points};
    (Pack(0.5) / Law<Pack>(parameters_of(arrays, 0)).bulk_modulus()).store(out);
  }
  std::vector<ParameterProblem> check_start(const LawRows& at, const SymTensor<Real, 2>& sigma) const override
  {
    std::array<Real, n_state> state;
    if constexpr (requires { law_.check_start(sigma, state); }) {
      for (std::size_t s = 0; s < n_state; ++s) state[s] = *at.state(s);
      return law_of(at).check_start(sigma, state);
    }
    return {};
  }
  void start(const LawRows& at, const SymTensor<Real, 2>& sigma) const override
  {
    std::array<Real, n_state> state;
    if constexpr (requires { law_.start(sigma, state); }) {
      for (std::size_t s = 0; s < n_state; ++s) state[s] = *at.state(s);
      law_of(at).start(sigma, state);
      for (std::size_t s = 0; s < n_state; ++s) *at.state(s) = state[s];
    }
  }
  Real viscosity() const override { return viscosity_of(law_); }
  Real viscosity(const LawRows& at) const override { return viscosity_of(law_of(at)); }
  Real derived(int k, const LawRows& at) const override
  {
    std::array<Real, n_state> state;
    for (std::size_t s = 0; s < n_state; ++s) state[s] = *at.state(s);
    if constexpr (requires { law_.derived_value(k, state); }) return law_of(at).derived_value(k, state);
    return std::numeric_limits<Real>::quiet_NaN();
  }
  Real softened_strain() const override
  {
    if constexpr (requires { law_.softened_strain(); }) return law_.softened_strain();
    return std::numeric_limits<Real>::infinity();
  }
  std::span<const int> varying() const override { return varying_; }

 private:
  template <class AnyLaw>
  static void soften_pack(const AnyLaw& law, const SofteningOptions& options, const SofteningArrays& arrays, Index p)
  {
    std::array<Pack, n_state> state;
    for (std::size_t k = 0; k < n_state; ++k) state[k] = Pack::load(arrays.law.state(k) + p);
    law.soften(state, Pack::load(arrays.spread + p), options);
    for (std::size_t k : {Uniform::nonlocal_row, Uniform::softening_row}) state[k].store(arrays.law.state(k) + p);
  }

  template <class AnyLaw>
  static void update_pack(
      const AnyLaw& law, const StressArrays<2>& arrays, const std::array<Real*, n_state>& rows, Index p)
  {
    SymTensor<Pack, 2> sigma, d_eps;
    std::array<Pack, n_state> state;
    for (int k = 0; k < n_sym<2>; ++k) sigma[k] = Pack::load(arrays.sigma[k] + p);
    for (int k = 0; k < n_sym<2>; ++k) d_eps[k] = Pack::load(arrays.d_eps[k] + p);
    for (std::size_t k = 0; k < n_state; ++k) state[k] = Pack::load(rows[k] + p);
    Pack work;
    if constexpr (requires { law.update(sigma, state, d_eps, arrays.dt, work); })
      work = law.update(sigma, state, d_eps, arrays.dt, Pack::load(arrays.softening_scale + p));
    else
      work = law.update(sigma, state, d_eps, arrays.dt);
    for (int k = 0; k < n_sym<2>; ++k) sigma[k].store(arrays.sigma[k] + p);
    for (std::size_t k = 0; k < n_state; ++k) state[k].store(rows[k] + p);
    work.store(arrays.plastic_work + p);
  }

  /// Parameters of eight points; padding takes the reference values, so that it stays finite.
  template <class Arrays>
  std::array<Pack, n_parameters> parameters_of(const Arrays& arrays, Index p) const
  {
    const Mask in_use = lane_numbers() < Pack(static_cast<Real>(arrays.n_points - p));
    std::array<Pack, n_parameters> parameters;
    for (std::size_t k = 0; k < n_parameters; ++k) parameters[k] = Pack(values_[k]);
    for (std::size_t k = 0; k < varying_.size(); ++k) {
      Pack& parameter = parameters[static_cast<std::size_t>(varying_[k])];
      parameter = select(in_use, Pack::load(arrays.law.parameters(k) + p), parameter);
    }
    return parameters;
  }

  std::array<Real, n_parameters> reduced_values(Real factor) const
  {
    std::array<Real, n_parameters> values;
    for (std::size_t k = 0; k < n_parameters; ++k)
      values[k] = reduced(Uniform::parameters[k].reduction, values_[k], factor);
    return values;
  }

  /// Each lane by itself; most have the value of the one before.
  static void reduce_strengths(Real factor, std::array<Pack, n_parameters>& parameters)
  {
    for (std::size_t k = 0; k < n_parameters; ++k) {
      const Reduction reduction = Uniform::parameters[k].reduction;
      if (!is_strength(reduction)) continue;
      alignas(64) Real lanes[pack_width];
      parameters[k].store(lanes);
      Real value = lanes[0], other = reduced(reduction, value, factor);
      for (Real& lane : lanes) {
        if (lane != value) value = lane, other = reduced(reduction, value, factor);
        lane = other;
      }
      parameters[k] = Pack::load(lanes);
    }
  }

  /// The law with the parameters of one point.
  Uniform law_of(const LawRows& at) const
  {
    if (varying_.empty()) return law_;
    std::array<Real, n_parameters> values = values_;
    for (std::size_t k = 0; k < varying_.size(); ++k) values[static_cast<std::size_t>(varying_[k])] = *at.parameters(k);
    return Uniform(values);
  }

  static Real viscosity_of(const Uniform& law)
  {
    if constexpr (requires { law.viscosity(); }) return law.viscosity();
    return 0.0;
  }

  Uniform law_;
  std::array<Real, n_parameters> values_;
  std::vector<int> varying_;
};

template <template <class> class Law>
std::vector<ParameterProblem> check_law(std::span<const Real> values)
{
  const Law<Real> law(values);
  std::vector<ParameterProblem> problems;
  if constexpr (requires { law.check(); }) problems = law.check();
  if constexpr (requires { law.check_within_point(); })
    for (ParameterProblem& problem : law.check_within_point()) problems.push_back(std::move(problem));
  return problems;
}

template <template <class> class Law>
std::unique_ptr<Material> make_law(const MaterialType&, std::span<const Real> values, std::span<const int> varying)
{
  return std::make_unique<MaterialOf<Law>>(values, varying);
}

template <class Law>
constexpr bool law_depends_on_rate()
{
  if constexpr (requires { Law::depends_on_rate; }) return Law::depends_on_rate;
  return false;
}

template <class Law>
constexpr bool law_has_total_stress()
{
  if constexpr (requires { Law::total_stress; }) return Law::total_stress;
  return false;
}

/// A strength of total stress, a fluid, or no strength.
template <class Law>
constexpr bool law_ignores_pressure()
{
  if constexpr (requires { Law::ignores_pressure; }) return Law::ignores_pressure;
  return law_has_total_stress<Law>() || Law::state.empty();
}

template <class Law>
constexpr bool law_stiffens_with_stress()
{
  return requires(const Law& law, SymTensor<Real, 2> sigma) { law.moduli_at(sigma); };
}

template <class Law>
constexpr std::string_view reason_not_to_judge()
{
  if constexpr (requires { Law::not_judged; }) return Law::not_judged;
  return {};
}

/// Every parameter has a typical value that is allowed.
template <class Law>
constexpr bool has_typical_values()
{
  return std::ranges::all_of(Law::parameters, [](const ParameterInfo& p) { return p.range.contains(p.typical); });
}

/// Soil that remembers or flows has a strength, which `terp stability` reduces, or says why it may not be judged.
template <class Law>
constexpr bool may_be_judged_or_says_why()
{
  const bool has_strength =
      std::ranges::any_of(Law::parameters, [](const ParameterInfo& p) { return is_strength(p.reduction); });
  const bool elastic = Law::state.empty() && !law_depends_on_rate<Law>();
  return has_strength || elastic || !reason_not_to_judge<Law>().empty();
}

/// What the law changes, the points take back.
template <class Law>
constexpr bool gives_its_state_back()
{
  return std::ranges::none_of(Law::state, [](const StateInfo& s) { return s.averaging == Averaging::keep; });
}

template <class Law>
constexpr MaterialType describe_law(std::string_view name, std::string_view summary)
{
  static_assert(has_typical_values<Law>(), "a parameter of this law has no `typical` value, or one outside its range");
  static_assert(may_be_judged_or_says_why<Law>(),
      "this law has state or depends on the rate, but no parameter with a `reduction` and no reason `not_judged`");
  static_assert(gives_its_state_back<Law>(), "Averaging::keep is for parameters: a state variable would not change");
  MaterialType type{};
  type.name = name;
  type.summary = summary;
  type.equations = Law::equations;
  type.parameters = Law::parameters;
  type.state = Law::state;
  type.derived = Law::derived;
  type.total_stress = law_has_total_stress<Law>();
  type.ignores_pressure = law_ignores_pressure<Law>();
  type.depends_on_rate = law_depends_on_rate<Law>();
  type.stiffness_by_stress = law_stiffens_with_stress<Law>();
  type.not_judged = reason_not_to_judge<Law>();
  return type;
}

template <template <class> class Law>
constexpr MaterialType define_law(std::string_view name, std::string_view summary,
    const MaterialType* nonlocal = nullptr, const MaterialType* scaled = nullptr, const MaterialType* torn = nullptr)
{
  MaterialType type = describe_law<Law<Real>>(name, summary);
  type.check = &check_law<Law>;
  type.maker = &make_law<Law>;
  type.nonlocal = nonlocal;
  type.scaled = scaled;
  type.torn = torn;
  return type;
}

/// Of a law that does not soften: a type without a name.
template <template <class> class Law, template <template <class> class> class Form>
constexpr MaterialType define_form(std::string_view name, std::string_view summary)
{
  if constexpr (Softens<Law>) return define_law<Form<Law>::template Type>(name, summary);
  return {};
}

}  // namespace terp

/// Defines `material_NAME`, which materials.def lists.
#define TERP_MATERIAL_FORMS(name, Law, of, summary)                                      \
  constexpr MaterialType nonlocal_##of = define_form<Law, NonlocalForm>(#name, summary); \
  constexpr MaterialType scaled_##of = define_form<Law, ScaledForm>(#name, summary);     \
  constexpr MaterialType law_##of =                                                      \
      define_law<Law>(#name, summary, Softens<Law> ? &nonlocal_##of : nullptr, Softens<Law> ? &scaled_##of : nullptr);
#define TERP_MATERIAL_DEFINITION(name, Law, summary) \
  TERP_MATERIAL_FORMS(name, Law, name, summary)      \
  extern const MaterialType material_##name;         \
  constexpr MaterialType material_##name = law_##name;
/// Of a law with a limit of tension: Torn is the same law where that acts.
#define TERP_MATERIAL_THAT_TEARS(name, Law, Torn, summary) \
  TERP_MATERIAL_FORMS(name, Law, name, summary)            \
  TERP_MATERIAL_FORMS(name, Torn, torn_##name, summary)    \
  extern const MaterialType material_##name;               \
  constexpr MaterialType material_##name =                 \
      define_law<Law>(#name, summary, law_##name.nonlocal, law_##name.scaled, &law_torn_##name);
