// The law of a library that the user gives: what is known of it before the library is (soil/libraries/user_law.hpp).

#include "soil/laws/elastic_constants.hpp"

#include <array>

namespace terp {
namespace {

constexpr ParameterInfo of_the_same_value(ParameterInfo info, std::string_view meaning)
{
  info.meaning = meaning;
  info.may_vary = false;
  return info;
}

constexpr std::array parameters{
    of_the_same_value(shear_modulus_info,
        "largest elastic shear modulus of the law: the time step, the energies and the search for equilibrium follow "
        "from it"),
    of_the_same_value(poisson_ratio_info, "elastic Poisson's ratio that belongs to it"),
};

std::vector<ParameterProblem> check_nothing(std::span<const Real>) { return {}; }

constexpr MaterialType library_type()
{
  MaterialType type{};
  type.name = "library";
  type.summary = "a law of your own from a shared library: Abaqus UMAT, ESM of Anura3D, UDSM of Plaxis, or C";
  type.equations =
      "the library's own: it gets stress, state and strain increment of each point, and returns stress and state\n"
      "plastic work = sigma : (d_eps - C^-1 d_sigma), C of shear_modulus and poisson_ratio      (docs/user_laws.md)\n";
  type.parameters = parameters;
  type.depends_on_rate = true;
  type.not_judged = "Terp cannot know which of the library's parameters are strengths";
  type.by_library = true;
  type.looks_around = true;
  type.check = &check_nothing;
  return type;
}

}  // namespace

extern const MaterialType material_library;
constexpr MaterialType material_library = library_type();

}  // namespace terp
