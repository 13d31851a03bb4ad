// Stiffness is measured where the mean stress is largest: the time step must bear it there. Arrays that are too short
// are looked for where it is least, as soil must yield to use all of its parameters. Nobody knows what a law does: a
// copy of this process calls it.

#include "run/findings/library_warnings.hpp"

#include "model/libraries/law_stiffness.hpp"
#include "model/libraries/short_arrays.hpp"
#include "os/own_copy.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real tolerance = 0.05;  // of moduli that ought to be the same
/// Waves that cross a cell in half a step are beyond what any mesh of several cells bears: the limit is one step.
constexpr Real unstable = 2.0;

struct PlaceOfPoint {
  const PointBlock<2>* block = nullptr;
  Index lane = 0;
};

struct ExtremePoints {
  PlaceOfPoint deepest, shallowest;
};

ExtremePoints extreme_points(const State& state, Index material)
{
  ExtremePoints found;
  Real most = -1.0, least = std::numeric_limits<Real>::infinity();
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (block.material != material) return;
    const auto sigma = stress_at(block, lane);
    const Real size = std::abs(sigma[0] + sigma[1] + sigma[2]);
    if (size > most) most = size, found.deepest = {&block, lane};
    if (size < least) least = size, found.shallowest = {&block, lane};
  });
  return found;
}

bool is_near(Real a, Real b) { return std::abs(a - b) <= tolerance * std::abs(b); }

std::string four_digits(Real value) { return fmt::format("{:.4g}", value); }

/// Moduli of isotropic soil as keys of the case; empty: there are none.
std::string keys_of(Real normal, Real shear)
{
  const Real poisson = (normal - 2.0 * shear) / (2.0 * (normal - shear));
  if (!(shear > 0.0 && normal > 4.0 / 3.0 * shear && poisson < 0.5)) return "moduli that are as stiff";
  return fmt::format("shear_modulus = {} and poisson_ratio = {:.3g}", four_digits(shear), poisson);
}

class LibraryScales {
 public:
  LibraryScales(const Model& model, Index m, const LawStiffness& law, std::vector<Problem>& warnings)
      : model_(model), soil_(model.materials[m]), law_(law), given_(soil_.law->moduli()), warnings_(warnings)
  {
  }

  void check()
  {
    refuse_unstable();
    const bool is_isotropic = is_near(law_.shear, law_.shear_of_axes);
    if (law_.is_elastic && !is_isotropic) warn_of_directions();
    const Real stiffest = std::max(law_.normal / given_.p_wave(), law_.shear / given_.shear);
    if (stiffest > 1.0 + tolerance && (is_isotropic || !fits_along_axes()))
      warn("the law of the library is stiffer than the case says",
          fmt::format("{}\nThe time step follows from the moduli of the case, and is too long by a factor of {:.2f}. "
                      "Give {}.",
              both(), std::sqrt(std::max(1.0, law_.normal / given_.p_wave())), keys_of(law_.normal, law_.shear)));
    else if (law_.is_elastic && is_isotropic && is_too_soft())
      warn("the law of the library is softer than the case says",
          fmt::format("{}\nEnergies, plastic work and time step follow from the moduli of the case. Look at the "
                      "parameters of the law and its\nunits, or give {}. All is well if the stiffness follows the "
                      "stress, and these are its largest moduli.",
              both(), keys_of(law_.normal, law_.shear)));
  }

 private:
  bool fits_along_axes() const { return is_near(law_.normal, given_.p_wave()); }

  bool is_too_soft() const
  {
    return law_.normal < (1.0 - tolerance) * given_.p_wave() || law_.shear < (1.0 - tolerance) * given_.shear;
  }

  std::string both() const
  {
    return fmt::format(
        "Small strains of a point give K + 4G/3 = {} Pa and G = {} Pa; shear_modulus and poisson_ratio "
        "say {} Pa and {} Pa.",
        four_digits(law_.normal), four_digits(law_.shear), four_digits(given_.p_wave()), four_digits(given_.shear));
  }

  Problem problem(std::string what, std::string detail) const
  {
    const std::string path = fmt::format("material.\"{}\"", soil_.name);
    return {path + ".shear_modulus", std::move(what), std::move(detail), "library", false, {path + ".library", path}};
  }

  void warn(std::string what, std::string detail) { warnings_.push_back(problem(std::move(what), std::move(detail))); }

  void refuse_unstable() const
  {
    const Real courant = model_.description.time.courant;
    const Real ratio = std::sqrt((law_.normal + soil_.water_stiffness) / (given_.p_wave() + soil_.water_stiffness));
    if (!(courant * ratio > unstable)) return;
    throw InputError(problem("the law of the library is too stiff for the time step",
        fmt::format("{}\nA wave would cross {:.3g} cells in a step: the run would be unstable. Look at the units of "
                    "the parameters and at\nstress_unit, or give {}.",
            both(), courant * ratio, keys_of(law_.normal, law_.shear))));
  }

  void warn_of_directions()
  {
    const Real ratio = law_.shear / law_.shear_of_axes;
    const char* cause = is_near(ratio, 2.0) || is_near(ratio, 0.5)
                            ? "A factor of 2 is that of the shear strain: a UMAT and an ESM are given engineering "
                              "shear, Terp's own interface tensorial."
                            : "Look at the shear terms of the law.";
    warn("the law of the library is stiffer in one direction of shearing than in another",
        fmt::format("G is {} Pa of the shear strain 12 (xy), {} Pa of the strains 11 and 22; shear_modulus = {} Pa.\n"
                    "{}\nAll is well if the law is anisotropic.",
            four_digits(law_.shear), four_digits(law_.shear_of_axes), four_digits(given_.shear), cause));
  }

  const Model& model_;
  const SoilMaterial& soil_;
  const LawStiffness& law_;
  Moduli given_;
  std::vector<Problem>& warnings_;
};

/// What a copy of this process hands on.
struct LibraryTrial {
  LawStiffness stiffness;
  std::string_view short_array;  ///< a constant; find_short_array
};
static_assert(std::is_trivially_copyable_v<LibraryTrial>);

LibraryTrial try_library(const Model& model, Index m, const ExtremePoints& points, double limit_s)
{
  const SoilMaterial& soil = model.materials[m];
  const auto& values = model.description.materials[static_cast<std::size_t>(m)].parameters;
  const auto size_at = [&](const PlaceOfPoint& at) { return std::sqrt(model.mesh->geometry(at.block->cell).volume); };
  const auto [deepest, shallowest] = points;
  LibraryTrial found;
  const std::string fault = call_in_copy(
      [&](void* result) {
        SoilMaterial trial = soil;  // a law that fails stays failed: the run has its own
        trial.law = trial.type->make(values);
        *static_cast<LibraryTrial*>(result) = {
            measure_stiffness(trial, *deepest.block, deepest.lane, size_at(deepest), model.dt),
            find_short_array(soil, values, *shallowest.block, size_at(shallowest), model.dt)};
      },
      &found, sizeof found, limit_s);
  if (fault.empty()) return found;
  const auto place = [](const PlaceOfPoint& at) {
    const auto x = [&](int k) { return at.block->row(PointRows<2>::x + k)[at.lane]; };
    return fmt::format("({:.4g}, {:.4g}) m", x(0), x(1));
  };
  throw InputError(Problem{fmt::format("material.\"{}\".library", soil.name),
      "the law of the library failed when it was tried",
      fmt::format("A copy of this program tried it, and {}.\nIt strained the points at {} and {} by 1e-6 to 1 %, with "
                  "dt = {:.3g} s. Call the law by itself with such strains,\nthen mend the library.",
          fault, place(deepest), place(shallowest), model.dt),
      "library", false, {fmt::format("material.\"{}\"", soil.name)}});
}

void refuse_short_array(const MaterialCase& material, std::string_view key)
{
  const LibraryCase& library = material.library;
  const bool is_state = key == "state", is_native = library.interface == LawInterface::native;
  const char* const of_them = is_state ? "state variables" : "parameters";
  const std::size_t n = is_state ? library.state.size() : library.parameters.size();
  const std::string path = fmt::format("material.\"{}\"", material.name);
  throw InputError(Problem{fmt::format("{}.{}", path, key),
      fmt::format(
          "the law of the library uses more {} than {}", of_them, is_native ? "it describes" : "the case gives"),
      fmt::format(
          "It is given {}, and what it returned for strains of 0.05 to 1 % changed with numbers that do not belong to "
          "it.\n{}",
          n,
          is_native ? fmt::format("Correct n_{} and the table in the description that the library gives.", key)
                    : fmt::format("Give all {} that the law has, in its order.", of_them)),
      "library", false, {path + ".library", path}});
}

}  // namespace

void find_odd_libraries(const Model& model, const State& state, std::vector<Problem>& warnings, double limit_s)
{
  for (Index m = 0; m < std::ssize(model.materials); ++m) {
    const MaterialCase& material = model.description.materials[static_cast<std::size_t>(m)];
    if (material.from_library == nullptr) continue;
    const ExtremePoints points = extreme_points(state, m);
    if (points.deepest.block == nullptr) continue;
    const LibraryTrial found = try_library(model, m, points, limit_s);
    if (!found.stiffness.failed) LibraryScales(model, m, found.stiffness, warnings).check();
    if (!found.short_array.empty()) refuse_short_array(material, found.short_array);
  }
}

}  // namespace terp
