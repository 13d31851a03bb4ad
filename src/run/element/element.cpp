// Unknown are the strain increments of the components whose stress is given, and of undrained soil the change of the
// pore pressure u. They solve
//
//   sigma_k(d_eps) - u = target_k of each such component,   tr(d_eps) + (n/K_w) d_u = 0 of undrained soil
//
// by Newton's method. Its tangent is the change of the law's own answer to a small change of each strain, from one call
// of the law with five points. An increment that leads nowhere is halved.

#include "run/element/element.hpp"

#include "math/errors.hpp"
#include "math/pack.hpp"
#include "model/parts/initial.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/water/nodal_water.hpp"
#include "soil/laws/elastic_constants.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr int n_components = n_sym<2>, n_unknowns = n_components + 1;  // strains xx yy zz xy, pore pressure
constexpr const char* component_names[] = {"xx", "yy", "zz", "xy"};
constexpr Real small_change = 1e-6;    // of the strains of an increment, for the tangent
constexpr Real least_change = 1e-10;   // [-]
constexpr Real settled = 1e-13;        // of the largest stress
constexpr Real loosely_settled = 1e4;  // times that, where no step leads further: a law may not be smooth
constexpr int most_iterations = 40, most_halvings = 10, most_cuts = 8;

using Components = std::array<Real, n_components>;
using Unknowns = std::array<Real, n_unknowns>;
using Matrix = std::array<Unknowns, n_unknowns>;

struct PointState {
  Components sigma{}, strain{};
  std::vector<Real> state;
  Real pore_pressure = 0.0, time = 0.0;
  std::int64_t step = 0;
};

/// The answers of a law to up to eight strain increments from one state.
class LawCall {
 public:
  explicit LawCall(const ElementSoil& soil) : soil_(soil), n_state_(soil.type->state.size()), state_(n_state_ + 1)
  {
    id_.value.fill(0.0), zero_.value.fill(0.0), scale_.value.fill(1.0);
  }

  /// Lanes beyond the last increment repeat that.
  void operator()(const PointState& from, std::span<const Components> increments, Real dt)
  {
    for (std::size_t lane = 0; lane < pack_width; ++lane) {
      const Components& d_eps = increments[std::min(lane, increments.size() - 1)];
      for (int k = 0; k < n_components; ++k) sigma_[k].value[lane] = from.sigma[k];
      for (int k = 0; k < n_components; ++k) d_eps_[k].value[lane] = d_eps[k];
      for (std::size_t k = 0; k < n_state_; ++k) state_[k].value[lane] = from.state[k];
    }
    static constexpr std::array<Index, 1> cell{0};
    static constexpr std::array<Real, 1> size{1.0};
    Surroundings<2> around{.time = from.time, .step = from.step, .cells = cell, .cell_sizes = size};
    around.x = {zero_.value.data(), zero_.value.data()};
    around.d_spin = zero_.value.data();
    around.id = id_.value.data();
    StressArrays<2> arrays{};
    for (int k = 0; k < n_components; ++k) arrays.sigma[k] = sigma_[k].value.data();
    for (int k = 0; k < n_components; ++k) arrays.d_eps[k] = d_eps_[k].value.data();
    arrays.law.state = {.data = state_.front().value.data(), .stride = pack_width};
    arrays.softening_scale = scale_.value.data();
    arrays.plastic_work = work_.value.data();
    arrays.n = pack_width;
    arrays.n_points = static_cast<Index>(increments.size());
    arrays.dt = dt;
    arrays.at_strength = soil_.at_strength;
    arrays.around = &around;
    soil_.law->update(arrays);
  }

  Real sigma(int k, std::size_t lane) const { return sigma_[k].value[lane]; }
  Real state(std::size_t k) const { return state_[k].value[0]; }

 private:
  struct alignas(64) Row {
    std::array<Real, pack_width> value;
  };
  const ElementSoil& soil_;
  std::size_t n_state_;
  std::array<Row, n_components> sigma_, d_eps_;
  std::vector<Row> state_;  // one more than the law has, so that there is a first one
  Row work_, id_, zero_, scale_;
};

/// The step dx of the free unknowns that J dx = -r asks for, the shortest of several: on an edge of its yield surface
/// soil has one stress for many strains. False: r is not a number.
bool find_step(const Matrix& j, const Unknowns& r, std::span<const int> free, Unknowns& dx)
{
  constexpr Real slight = 1e-10;  // beside the square of J, whose rows are of the size of 1
  const std::size_t n = free.size();
  Matrix a{};  // J^T J, lower part, then its factor
  Unknowns b{};
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t q = 0; q <= p; ++q)
      for (const int row : free) a[p][q] += j[row][free[p]] * j[row][free[q]];
    a[p][p] += slight;
    for (const int row : free) b[p] -= j[row][free[p]] * r[row];
  }
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t k = 0; k < c; ++k) a[c][c] -= a[c][k] * a[c][k], b[c] -= a[c][k] * b[k];
    if (!(a[c][c] > 0.0)) return false;
    a[c][c] = std::sqrt(a[c][c]), b[c] /= a[c][c];
    for (std::size_t row = c + 1; row < n; ++row) {
      for (std::size_t k = 0; k < c; ++k) a[row][c] -= a[row][k] * a[c][k];
      a[row][c] /= a[c][c];
    }
  }
  dx.fill(0.0);
  for (std::size_t c = n; c-- > 0;) {
    for (std::size_t k = c + 1; k < n; ++k) b[c] -= a[k][c] * dx[free[k]];
    dx[free[c]] = b[c] / a[c][c];
  }
  return true;
}

class Element {
 public:
  Element(const ElementSoil& soil, const ElementPath& path)
      : soil_(soil),
        path_(path),
        law_(soil),
        modulus_(soil.law->p_wave_modulus() > 0.0 ? soil.law->p_wave_modulus() : 1.0)
  {
    at_.sigma = path.stress;
    for (const StateInfo& info : soil.type->state) at_.state.push_back(info.initial);
  }

  const PointState& at() const { return at_; }

  /// One increment to where the components are given, in as many parts as it takes. False: no answer.
  bool advance(const ElementLeg& leg, const Components& target, Real dt, int cuts = 0)
  {
    const PointState before = at_;
    if (increment(leg, target, dt)) return true;
    at_ = before;
    if (cuts == most_cuts || !soil_.law->fault().empty()) return false;
    Components half;
    for (int k = 0; k < n_components; ++k) half[k] = 0.5 * (value(leg, k) + target[k]);
    return advance(leg, half, 0.5 * dt, cuts + 1) && advance(leg, target, 0.5 * dt, cuts + 1);
  }

  /// What a leg prescribes of a component, now.
  Real value(const ElementLeg& leg, int k) const
  {
    return leg.control[k] == Control::strain ? at_.strain[k] : at_.sigma[k] - (k < 3 ? at_.pore_pressure : 0.0);
  }

 private:
  struct Trial {
    Unknowns residual;  // over the stiffness of the soil: of the size of strains
    Real size;          // the largest
  };

  /// The law's answer to x with its tangent, both in the rows of the equations.
  Trial try_strain(const ElementLeg& leg, const Components& target, const Unknowns& x, Real dt, Matrix* tangent)
  {
    std::array<Components, n_unknowns> increments;
    Components& base = increments[0];
    std::copy_n(x.begin(), n_components, base.begin());
    Real largest = 0.0;
    for (const Real strain : base) largest = std::max(largest, std::abs(strain));
    const Real h = least_change + small_change * largest;
    for (int j = 0; j < n_components; ++j) increments[j + 1] = base, increments[j + 1][j] += h;
    law_(at_, std::span(increments).first(tangent != nullptr ? n_unknowns : 1), dt);
    Trial trial{};
    for (int k = 0; k < n_components; ++k) {
      const bool is_strain = leg.control[k] == Control::strain;
      const Real pore_pressure = k < 3 ? at_.pore_pressure + x[n_components] * modulus_ : 0.0;
      trial.residual[k] =
          is_strain ? at_.strain[k] + x[k] - target[k] : (law_.sigma(k, 0) - pore_pressure - target[k]) / modulus_;
      if (tangent == nullptr) continue;
      Unknowns& row = (*tangent)[k];
      for (int j = 0; j < n_components; ++j) row[j] = (law_.sigma(k, j + 1) - law_.sigma(k, 0)) / (h * modulus_);
      row[n_components] = k < 3 ? -1.0 : 0.0;
    }
    const Real compressibility = soil_.water_compressibility * modulus_;
    if (is_undrained()) trial.residual[n_components] = x[0] + x[1] + x[2] + compressibility * x[n_components];
    if (tangent != nullptr) (*tangent)[n_components] = {1.0, 1.0, 1.0, 0.0, compressibility};
    for (const Real r : trial.residual) trial.size = std::isnan(r) ? r : std::max(trial.size, std::abs(r));
    return trial;
  }

  bool is_undrained() const { return path_.undrained && soil_.stores_effective; }

  /// Below which a residual is round-off.
  Real limit(const Components& target, const ElementLeg& leg) const
  {
    Real largest = 1e-9 * modulus_;
    for (int k = 0; k < n_components; ++k)
      largest = std::max({largest, std::abs(at_.sigma[k]), std::abs(law_.sigma(k, 0)),
          leg.control[k] == Control::stress ? std::abs(target[k]) : 0.0});
    return settled * largest / modulus_;
  }

  bool increment(const ElementLeg& leg, const Components& target, Real dt)
  {
    Unknowns x{};
    for (int k = 0; k < n_components; ++k)
      if (leg.control[k] == Control::strain) x[k] = target[k] - at_.strain[k];
    std::vector<int> free;
    for (int k = 0; k < n_components; ++k)
      if (leg.control[k] == Control::stress) free.push_back(k);
    if (is_undrained()) free.push_back(n_components);
    Matrix tangent;
    Trial trial = try_strain(leg, target, x, dt, &tangent);
    for (int k = 0; k < most_iterations && trial.size > limit(target, leg); ++k) {
      Unknowns step, next;
      if (!soil_.law->fault().empty() || !find_step(tangent, trial.residual, free, step)) return false;
      Real part = 1.0;
      Trial better;
      for (int halving = 0;; ++halving, part *= 0.5) {
        for (int i = 0; i < n_unknowns; ++i) next[i] = x[i] + part * step[i];
        better = try_strain(leg, target, next, dt, &tangent);
        if (better.size < trial.size || halving == most_halvings) break;
      }
      if (!(better.size < trial.size)) {
        trial = try_strain(leg, target, x, dt, &tangent);
        break;
      }
      x = next, trial = better;
    }
    if (!(trial.size <= loosely_settled * limit(target, leg)) || !soil_.law->fault().empty()) return false;
    for (int k = 0; k < n_components; ++k) at_.sigma[k] = law_.sigma(k, 0), at_.strain[k] += x[k];
    for (std::size_t k = 0; k < at_.state.size(); ++k) at_.state[k] = law_.state(k);
    at_.pore_pressure += x[n_components] * modulus_;
    at_.time += dt;
    ++at_.step;
    return true;
  }

  const ElementSoil& soil_;
  const ElementPath& path_;
  LawCall law_;
  Real modulus_;  // K + 4G/3 [Pa]
  PointState at_;
};

/// The columns of a result, and what an increment adds to them.
class ElementTable {
 public:
  ElementTable(const ElementSoil& soil, Real void_ratio) : soil_(soil), void_ratio_(void_ratio)
  {
    add("time", "s", "time");
    for (const char* name : component_names) add(fmt::format("strain_{}", name), "-", fmt::format("strain {}", name));
    const std::string kind = soil.stores_effective ? "effective stress " : "stress ";
    for (const char* name : component_names) add(fmt::format("stress_{}", name), "Pa", kind + name);
    add("pore_pressure", "Pa", "pore pressure");
    add("mean_pressure", "Pa", soil.stores_effective ? "mean effective pressure p'" : "mean pressure p");
    add("deviator", "Pa", "deviator stress q");
    add("volume_strain", "-", "volume strain");
    add("deviator_strain", "-", "deviator strain");
    if (!std::isnan(void_ratio)) add("void_ratio", "-", "void ratio e");
    for (const StateInfo& info : soil.type->state)
      if (info.shown && !info.scratch) add(std::string(info.name), info.unit, info.meaning);
    for (const DerivedInfo& info : soil.type->derived) add(std::string(info.name), info.unit, info.meaning);
  }

  void add_row(const PointState& at)
  {
    std::size_t column = 0;
    const auto put = [&](Real value) { result.columns[column++].values.push_back(value); };
    const Real mean = (at.sigma[0] + at.sigma[1] + at.sigma[2]) / 3.0,
               volume = at.strain[0] + at.strain[1] + at.strain[2];
    put(at.time);
    for (const Real strain : at.strain) put(strain);
    for (const Real stress : at.sigma) put(stress);
    put(soil_.stores_effective ? at.pore_pressure : std::numeric_limits<Real>::quiet_NaN());
    put(-mean);
    put(std::sqrt(1.5 * square_of_deviator(at.sigma)));
    put(volume);
    put(std::sqrt(square_of_deviator(at.strain) / 1.5));
    if (!std::isnan(void_ratio_)) put((1.0 + void_ratio_) * std::exp(volume) - 1.0);
    for (std::size_t k = 0; k < at.state.size(); ++k)
      if (soil_.type->state[k].shown && !soil_.type->state[k].scratch) put(at.state[k]);
    std::vector<Real> state = at.state;
    for (std::size_t k = 0; k < soil_.type->derived.size(); ++k)
      put(soil_.law->derived(static_cast<int>(k), {{.data = state.data()}, {}}));
  }

  ElementResult result;

 private:
  void add(std::string name, std::string_view unit, std::string_view label)
  {
    result.columns.push_back({std::move(name), std::string(unit), std::string(label), {}});
  }
  static Real square_of_deviator(const Components& a)
  {
    const Real mean = (a[0] + a[1] + a[2]) / 3.0;
    Real sum = 2.0 * a[3] * a[3];
    for (int k = 0; k < 3; ++k) sum += (a[k] - mean) * (a[k] - mean);
    return sum;
  }

  const ElementSoil& soil_;
  Real void_ratio_;
};

void refuse(const std::string& key, const std::string& what, const std::string& detail)
{
  throw InputError(Problem{key, what, detail, "material"});
}

void check_start(const ElementSoil& soil, const ElementPath& path, std::vector<Real> state)
{
  SymTensor<Real, 2> sigma;
  for (int k = 0; k < n_components; ++k) sigma[k] = path.stress[k];
  for (const ParameterProblem& problem : soil.law->check_start({{.data = state.data()}, {}}, sigma))
    refuse(fmt::format("material.{}.{}", soil.name, problem.parameter), problem.what, problem.detail);
}

/// Water that cannot be compressed keeps the volume, and its pressure follows from a normal stress.
void check_undrained(const ElementSoil& soil, const ElementPath& path)
{
  if (!path.undrained || !soil.stores_effective || soil.water_compressibility > 0.0) return;
  for (const ElementLeg& leg : path.legs)
    if (std::all_of(leg.control.begin(), leg.control.begin() + 3, [](Control c) { return c == Control::strain; }))
      refuse("material." + soil.name, "undrained soil whose water cannot be compressed takes no path of strains alone",
          "Its volume is constant, and its pore pressure follows from a normal stress. Give the stress of one normal\n"
          "component, a drained test, or drainage = \"undrained_effective\" in the case, whose water has a stiffness.");
}

std::string words_of_fault(const ElementSoil& soil, const ElementLeg& leg, const Components& target, std::int64_t step)
{
  if (const std::string fault = soil.law->fault(); !fault.empty()) return fault;
  std::string stresses;
  for (int k = 0; k < n_components; ++k)
    if (leg.control[k] == Control::stress)
      stresses += fmt::format("{}stress_{} = {:.6g} Pa", stresses.empty() ? "" : ", ", component_names[k], target[k]);
  return fmt::format(
      "no strain leads from increment {} to {}. A load beyond the strength of the soil does this: prescribe "
      "a strain in its place, or try more increments",
      step, stresses);
}

}  // namespace

namespace {

ElementSoil soil_of(const Case& c, const MaterialCase& material, std::span<const Real> parameters)
{
  const MaterialType* plain = find_material(material.model, {}, material.tears());
  ElementSoil soil{.name = material.called(),
      .type = plain != nullptr && plain->by_library ? material.from_library.get() : plain,
      .at_strength = c.at_strength,
      .stores_effective = material.stores_effective()};
  soil.law = soil.type->make(parameters);
  if (!material.has_excess_pressure()) return soil;
  const Moduli moduli = soil.law->moduli();
  const Real stiffness = std::isnan(material.water_stiffness)
                             ? bulk_from_poisson(moduli.shear, material.undrained_poisson_ratio) - moduli.bulk
                             : material.water_stiffness;
  if (!(stiffness > 0.0))
    refuse(parameter_key(material, "undrained_poisson_ratio"), less_compressible_than_soil,
        fmt::format("undrained_poisson_ratio = {:g}; it must be above the Poisson's ratio of the soil.",
            material.undrained_poisson_ratio));
  soil.water_compressibility = 1.0 / stiffness;
  return soil;
}

}  // namespace

ElementSoil element_soil(const Case& c, const MaterialCase& material)
{
  if (!material.fields.empty()) {
    const auto& info = material.type()->parameters[material.fields.front().parameter];
    refuse(parameter_key(material, info.name), "the parameter varies from place to place, and an element has no place",
        fmt::format("Give the element a place, --at X,Y, or the parameter a value: --set '{}=VALUE'.",
            parameter_key(material, info.name)));
  }
  return soil_of(c, material, material.parameters);
}

ElementAtPlace element_at(const Model& model, const MaterialCase& material, Vec<2> x)
{
  const Case& c = model.description;
  const Overburden overburden(model);
  const PlaceInSoil place{x, &overburden};
  const std::optional<Real> ground = overburden.ground(x[0]);
  if (!ground || x[1] > *ground)
    throw InputError(Problem{"body", "there is no soil at the place of the element",
        ground ? fmt::format("The ground at x = {:g} m is at y = {:g} m; got y = {:g} m.", x[0], *ground, x[1])
               : fmt::format("No body is at x = {:g} m.", x[0]),
        "body"});
  const WaterWay way = model.with.water ? first_way(model) : WaterWay{};
  const WaterSituation& water = situation_of(c.water, way.share > 0.0 ? way.to : way.from);
  const Real vertical = overburden.effective(x, water), k0 = k0_at(c, material, place, vertical);
  return {soil_of(c, material, parameters_at(material, *material.type(), place)),
      {-k0 * vertical, -vertical, -k0 * vertical, 0.0}};
}

const std::vector<Real>& ElementResult::at(std::string_view name) const
{
  return std::ranges::find(columns, name, &ElementColumn::name)->values;
}

ElementResult follow_path(const ElementSoil& soil, const ElementPath& path, Real void_ratio)
{
  check_undrained(soil, path);
  Element element(soil, path);
  check_start(soil, path, element.at().state);
  ElementTable table(soil, void_ratio);
  table.add_row(element.at());
  for (const ElementLeg& leg : path.legs) {
    Components from, target;
    for (int k = 0; k < n_components; ++k) from[k] = element.value(leg, k);
    for (int i = 1; i <= leg.increments; ++i) {
      const Real share = static_cast<Real>(i) / leg.increments;
      for (int k = 0; k < n_components; ++k)
        target[k] = std::isnan(leg.target[k]) ? from[k] : std::lerp(from[k], leg.target[k], share);
      if (element.advance(leg, target, leg.duration / leg.increments)) {
        table.add_row(element.at());
        continue;
      }
      table.result.fault = words_of_fault(soil, leg, target, std::ssize(table.result.columns.front().values) - 1);
      return std::move(table.result);
    }
  }
  return std::move(table.result);
}

}  // namespace terp
