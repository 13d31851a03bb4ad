// Numbers that the case gives by name are put in the order of the library, and later only their places count. A library
// that cannot describe itself (UMAT, ESM) is believed: its parameters and state are those of the case.

#include "soil/libraries/describe_library.hpp"

#include "math/closest.hpp"
#include "math/errors.hpp"
#include "os/files.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace terp {
namespace {

using Variables = std::vector<LawVariables::Variable>;

[[noreturn]] void refuse(const std::string& key, const std::string& what, const std::string& detail)
{
  throw InputError(Problem{key, what, detail, "library"});
}

/// Of Abaqus, in cases/user_law/abaqus.f90.
constexpr std::string_view utility_routines[] = {
    "rotsig_", "sinv_", "sprinc_", "sprind_", "xit_", "stdb_abqerr_", "getoutdir_", "getjobname_"};

std::string advice_on_opening(const std::string& why)
{
  for (const std::string_view routine : utility_routines)
    if (why.ends_with(fmt::format("undefined symbol: {}", routine)))
      return fmt::format(
          "`{}` is a utility routine of Abaqus. Build the library with abaqus.f90, which lies beside the "
          "example (docs/user_laws.md):\ngfortran -O2 -fPIC -shared LAW.f abaqus.f90 -o LAW.so",
          routine.substr(0, routine.size() - 1));
  if (why.find("undefined symbol") != std::string::npos)
    return "The library calls a function that it does not contain: give the linker the file or library that has it "
           "(docs/user_laws.md).";
  if (why.find("cannot open shared object") != std::string::npos)
    return "Another library that it needs is not installed; `ldd` lists what it needs.";
  if (why.find("invalid ELF header") != std::string::npos || why.find("file too short") != std::string::npos)
    return "This is no shared library. Build it with `-shared -fPIC`, as in docs/user_laws.md.";
  if (why.find("LoadLibrary") != std::string::npos)  // Windows
    return "Build it with `-static`, so that it needs no other: gfortran -O2 -shared -static LAW.f90 -o LAW.dll";
  return "Build it on this machine with `-shared -fPIC`, as in docs/user_laws.md.";
}

bool is_name(const std::string& text)
{
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !text.empty() && is_letter(text[0]) &&
         std::ranges::all_of(text, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

void check_names(const std::string& key, const char* what, const std::vector<NamedNumber>& numbers)
{
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::string& name = numbers[k].name;
    if (name.empty() && key == "state")
      refuse(key, "a state variable has no name", "Give each a name, or their number alone.");
    if (!name.empty() && !is_name(name))
      refuse(key, fmt::format("`{}` is no name of a {}", name, what), "Names have letters, digits and _ only.");
    const auto same = [&](const NamedNumber& other) { return other.name == name; };
    if (!name.empty() && std::count_if(numbers.begin(), numbers.end(), same) > 1)
      refuse(key, fmt::format("two entries have the name `{}`", name), "Give each its own.");
  }
}

/// What the library has, as detail of a message.
std::string those_of(const Variables& variables)
{
  std::string names;
  for (const auto& variable : variables) names += (names.empty() ? "" : ", ") + variable.name;
  return fmt::format("Those of the library, in its order: {}.", names.empty() ? "none" : names);
}

std::size_t number_of(const std::string& key, const char* what, const Variables& known, const std::string& name)
{
  const auto found = std::ranges::find(known, name, &LawVariables::Variable::name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  std::vector<std::string> names;
  for (const auto& variable : known) names.push_back(variable.name);
  refuse(key, fmt::format("the library has no {} `{}`", what, name), did_you_mean(name, names) + those_of(known));
}

constexpr std::size_t longest_unit = 20;

/// Parameters in the order of the library, all of them.
void order_parameters(const Variables& known, std::vector<NamedNumber>& given)
{
  const auto refuse_count = [&](std::size_t n) {
    refuse("parameters", fmt::format("the library takes {} parameters, the case gives {}", known.size(), n),
        those_of(known));
  };
  std::vector<NamedNumber> ordered;
  for (const auto& variable : known) ordered.push_back({variable.name, std::numeric_limits<Real>::quiet_NaN()});
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (given[k].name.empty() && given.size() != known.size()) refuse_count(given.size());
    ordered[given[k].name.empty() ? k : number_of("parameters", "parameter", known, given[k].name)].value =
        given[k].value;
  }
  for (const NamedNumber& number : ordered)
    if (std::isnan(number.value))
      refuse("parameters", fmt::format("the parameter `{}` of the library is missing", number.name), those_of(known));
  given = std::move(ordered);
}

/// The state that the library names; the case may give other initial values, by name.
void order_state(const Variables& known, std::vector<NamedNumber>& given)
{
  std::vector<NamedNumber> ordered;
  for (const auto& variable : known) ordered.push_back({variable.name, variable.initial});
  for (const NamedNumber& number : given)
    ordered[number_of("state", "state variable", known, number.name)].value = number.value;
  given = std::move(ordered);
}

/// Another interface whose function the library has, in words; empty: none.
std::string other_interface(const SharedLibrary& library)
{
  for (const InterfaceInfo& info : law_interfaces())
    for (const std::string_view symbol : info.usual_symbols)
      if (library.find(std::string(symbol)) != nullptr)
        return fmt::format("It has {}, that of interface = \"{}\". Give this interface.\n", symbol, info.name);
  return {};
}

}  // namespace

FoundLibrary find_library(const std::string& folder, const LibraryCase& library)
{
  FoundLibrary found;
  found.path = is_absolute(library.file) || folder.empty() ? library.file : folder + '/' + library.file;
  try {
    found.library = std::make_shared<const SharedLibrary>(found.path);
  } catch (const FileError& error) {
    refuse("library", "the library cannot be opened",
        fmt::format("{}\n{}", error.what(), advice_on_opening(error.what())));
  }
  const InterfaceInfo& interface = info_of(library.interface);
  std::vector<std::string> symbols(interface.usual_symbols.begin(), interface.usual_symbols.end());
  if (!library.symbol.empty()) symbols = {library.symbol};
  for (const std::string& symbol : symbols)
    if (found.function = found.library->find(symbol); found.function != nullptr) {
      found.symbol = symbol;
      return found;
    }
  refuse(library.symbol.empty() ? "library" : "symbol",
      fmt::format("the library has no function {}", fmt::join(symbols, " or ")),
      (library.symbol.empty() ? other_interface(*found.library) : "") +
          fmt::format("`nm -D {}` lists what it offers. Name the function with `symbol`; gfortran writes names in "
                      "small letters with _ at the end.",
              library.file));
}

std::optional<LawVariables> describe_library(const FoundLibrary& found, LibraryCase& library)
{
  check_names("parameters", "parameter", library.parameters);
  check_names("state", "state variable", library.state);
  std::optional<LawVariables> said;
  try {
    said = info_of(library.interface).describe(found.function, library);
  } catch (const InputError& error) {
    const Problem& problem = error.problems().front();
    refuse(problem.key.empty() ? "library" : problem.key, problem.what, problem.detail);
  }
  if (!said) return said;
  for (const Variables* variables : {&said->parameters, &said->state})
    for (const auto& variable : *variables)
      if (!is_name(variable.name))
        refuse("library", fmt::format("the library has a variable named `{}`", variable.name),
            "Names have letters, digits and _ only.");
  order_parameters(said->parameters, library.parameters);
  order_state(said->state, library.state);
  if (library.thread_safe && !said->thread_safe)
    refuse("thread_safe", "the library says of itself that it is not thread safe", "Remove `thread_safe`.");
  library.thread_safe = said->thread_safe;
  return said;
}

std::vector<std::string> take_units(LibraryCase& library)
{
  std::vector<std::string> units;
  for (NamedNumber& number : library.state) {
    std::string& unit = units.emplace_back();
    const auto begin = number.name.find(" [");
    if (begin == std::string::npos || number.name.back() != ']') continue;
    unit = number.name.substr(begin + 2, number.name.size() - begin - 3);
    const auto is_allowed = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '['; };
    if (unit.empty() || unit.size() > longest_unit || !std::ranges::all_of(unit, is_allowed))
      refuse("state", fmt::format("`{}` has no unit that can be read", number.name),
          fmt::format("A unit has 1 to {} letters: \"p_0 [kPa]\".", longest_unit));
    number.name.resize(begin);
    if (library.interface == LawInterface::native)
      refuse("state", fmt::format("the library says itself what the unit of `{}` is", number.name),
          "Give its name without a unit.");
  }
  return units;
}

void check_terms(const LibraryCase& library, const LawTerms& terms)
{
  Variables known;
  for (const NamedNumber& number : library.state) known.push_back({number.name, "", "", number.value});
  if (!terms.plastic_strain.empty()) number_of("plastic_strain", "state variable", known, terms.plastic_strain);
  if (terms.strength.empty() && !std::isnan(terms.residual_strength))
    refuse("residual_strength", "nothing says which state variable is the strength",
        "Give its name as `strength`, or remove `residual_strength`.");
  if (terms.strength.empty()) return;
  const Real initial = known[number_of("strength", "state variable", known, terms.strength)].initial;
  if (terms.strength == (terms.plastic_strain.empty() ? std::string(plastic_strain_name) : terms.plastic_strain))
    refuse("strength", fmt::format("`{}` cannot be the strength and the plastic strain", terms.strength),
        "Give the name of another state variable, or remove one of the two keys.");
  if (!(initial > 0.0))
    refuse("strength", fmt::format("the strength `{}` is {:g} at t = 0", terms.strength, initial),
        fmt::format("Give the strength of soil that has not softened as its value at t = 0: state = {{ {} = VALUE }}.",
            terms.strength));
  if (terms.residual_strength > initial * library.stress_unit)
    refuse("residual_strength", "the residual strength is above that at t = 0",
        fmt::format("Got {:g} Pa; `{}` begins at {:g} Pa. Allowed: at most that.", terms.residual_strength,
            terms.strength, initial * library.stress_unit));
}

}  // namespace terp
