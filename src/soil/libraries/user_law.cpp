// A MaterialType points at texts and tables that others own. UserLaw owns those of a library, and nothing is added to
// its tables once they are set. Its materials hold it, and with it the library.

#include "soil/libraries/user_law.hpp"

#include "soil/libraries/describe_library.hpp"
#include "soil/libraries/library_material.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace terp {
namespace {

/// Keeps the texts that the tables of a MaterialType point at.
struct UserLaw final : MaterialType, std::enable_shared_from_this<UserLaw> {
  std::vector<StateInfo> own_state;
  std::vector<DerivedInfo> own_derived;
  LawTerms terms;
  std::vector<std::unique_ptr<std::string>> texts;
  LibraryInUse in_use;

  std::string_view keep(std::string text)
  {
    texts.push_back(std::make_unique<std::string>(std::move(text)));
    return *texts.back();
  }
};

std::string_view word_of(Real stress_unit) { return stress_unit == 1e6 ? "MPa" : stress_unit == 1e3 ? "kPa" : "Pa"; }

/// What the library says of itself, or the units that the case gives, in the order of the state; "": none.
struct SaidOfState {
  std::optional<LawVariables> library;
  std::vector<std::string> units;
};

std::string unit_of(const LibraryCase& library, const SaidOfState& said, const LawTerms& terms, std::size_t k)
{
  const std::string& unit = said.library ? said.library->state[k].unit : said.units[k];
  if (!unit.empty()) return unit;
  return std::string(library.state[k].name == terms.strength ? word_of(library.stress_unit) : "-");
}

void add_state(const LibraryCase& library, const SaidOfState& said, UserLaw& law)
{
  const std::string_view strain =
      law.terms.plastic_strain.empty() ? plastic_strain_name : std::string_view(law.terms.plastic_strain);
  for (std::size_t k = 0; k < library.state.size(); ++k) {
    const NamedNumber& number = library.state[k];
    const std::string meaning = said.library ? said.library->state[k].meaning : "";
    law.own_state.push_back({.name = law.keep(number.name),
        .unit = law.keep(unit_of(library, said, law.terms, k)),
        .averaging = Averaging::cell,
        .meaning = law.keep(meaning.empty() ? fmt::format("state variable {} of the library", k + 1) : meaning),
        .role = number.name == strain ? Role::plastic_strain : Role::none,
        .initial = number.value});
  }
  const auto add_kept = [&](const char* name, Real initial) {
    law.own_state.push_back({.name = name,
        .unit = "-",
        .averaging = Averaging::sub_cell,
        .meaning = "kept for the law",
        .initial = initial,
        .shown = false});
  };
  if (sets_state_in_first_call(library.interface)) add_kept("law_was_called", 0.0);
  if (keeps(library, "strain"))
    for (const char* name : {"law_strain_xx", "law_strain_yy", "law_strain_zz", "law_strain_xy"}) add_kept(name, 0.0);
  if (keeps(library, "deformation_gradient")) {
    for (const char* name : {"law_gradient_xx", "law_gradient_xy", "law_gradient_yx", "law_gradient_yy"})
      add_kept(name, name[13] == name[14] ? 1.0 : 0.0);
    add_kept("law_gradient_zz", 1.0);
  }
}

/// The field `su` of Terp's own laws.
void add_strength(UserLaw& law)
{
  if (law.terms.strength.empty()) return;
  law.own_derived.push_back({.name = "su",
      .unit = "Pa",
      .meaning = law.keep(fmt::format("current strength, the state variable {} of the library", law.terms.strength)),
      .role = Role::strength});
}

/// Number of the state variable that is the strength, of a law that has one.
std::size_t strength_row(const LibraryCase& library, const LawTerms& terms)
{
  return static_cast<std::size_t>(
      std::ranges::find(library.state, terms.strength, &NamedNumber::name) - library.state.begin());
}

std::unique_ptr<Material> make_library_law(const MaterialType& type, std::span<const Real> values, std::span<const int>)
{
  const auto& law = static_cast<const UserLaw&>(type);
  return std::make_unique<LibraryMaterial>(law.shared_from_this(), law.in_use, values);
}

}  // namespace

std::shared_ptr<const MaterialType> load_user_law(const std::string& material, const std::string& folder,
    std::span<const Real> moduli, LibraryCase& library, const LawTerms& terms, bool takes_turns)
{
  const FoundLibrary found = find_library(folder, library);
  std::vector<std::string> units = take_units(library);
  const std::optional<LawVariables> said = describe_library(found, library);
  units.resize(library.state.size());  // a UDSM adds those that the case leaves out
  check_terms(library, terms);
  if (takes_turns) library.thread_safe = false;
  const auto law = std::make_shared<UserLaw>();
  static_cast<MaterialType&>(*law) = *find_material("library");
  law->maker = &make_library_law;
  law->terms = terms;
  add_state(library, {said, units}, *law);
  add_strength(*law);
  law->state = law->own_state;
  law->derived = law->own_derived;
  law->in_use = {.material = material,
      .title = fmt::format("{} ({}, {})", library.file, info_of(library.interface).name, found.symbol),
      .library = found.library,
      .calls = info_of(library.interface).make(found.function, library, material, static_cast<int>(terms.n_components)),
      .turns = library.thread_safe ? nullptr : turns_of(found.path),
      .n_state = law->own_state.size(),
      .strength_row = strength_row(library, terms),
      .stress_unit = library.stress_unit,
      .shear_modulus = moduli[0]};
  return law;
}

const LawTerms* terms_of(const MaterialType& type)
{
  return type.maker == &make_library_law ? &static_cast<const UserLaw&>(type).terms : nullptr;
}

}  // namespace terp
