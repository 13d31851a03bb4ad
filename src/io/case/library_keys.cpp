// A library is opened only after the keys of its material were read without a problem: to load it runs its code. What
// the law alone knows of itself (plastic_strain, strength, components) is read with the other keys for its type alone,
// and again from the tree when the library is loaded (given_terms).

#include "io/case/library_keys.hpp"

#include "io/case/document.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/units.hpp"
#include "mpm/schemes/scheme.hpp"
#include "run/report/frame_fields.hpp"
#include "soil/libraries/interface.hpp"
#include "soil/libraries/user_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace terp {
namespace {

constexpr const char* kinematics_words[] = {"strain", "deformation_gradient"};

std::vector<std::string> interface_words()
{
  std::vector<std::string> words;
  for (const InterfaceInfo& info : law_interfaces()) words.emplace_back(info.name);
  return words;
}

std::vector<std::string> words_of_kinematics() { return {std::begin(kinematics_words), std::end(kinematics_words)}; }

std::string interface_meanings()
{
  std::string text = "how the functions of the library are called";
  for (const InterfaceInfo& info : law_interfaces())
    text += fmt::format("{} {}: {}", text.ends_with("called") ? "." : ";", info.name, info.meaning);
  return text;
}

constexpr Index most_state = 100;

struct NumbersReader {
  std::string_view form;
  bool takes_names;  ///< a list of names, whose numbers are 0
  bool takes_count;  ///< an integer: that many numbers 0

  bool wrong(const Entry& entry, const Node& node, const std::string& path, Findings& findings) const
  {
    findings.problems.push_back({path, fmt::format("`{}` cannot be {}", last_part(entry.path), describe_value(node)),
        fmt::format("Allowed: {}.", form), topic_of(entry.key.path)});
    return false;
  }

  bool read(const Entry& entry, std::vector<NamedNumber>& numbers, Findings& findings) const
  {
    const Node& node = entry.node;
    numbers.clear();
    if (node.kind == NodeKind::integer && takes_count) {
      if (node.integer < 0 || node.integer > most_state) return wrong(entry, node, entry.path, findings);
      for (Index k = 1; k <= node.integer; ++k) numbers.push_back({fmt::format("state_{}", k), 0.0});
      return true;
    }
    if (node.kind != NodeKind::list && node.kind != NodeKind::table) return wrong(entry, node, entry.path, findings);
    if (takes_count && std::ssize(node.items) > most_state) return wrong(entry, node, entry.path, findings);
    for (std::size_t k = 0; k < node.items.size(); ++k) {
      const Node& item = node.items[k];
      const bool is_list = node.kind == NodeKind::list;
      const std::string path = is_list ? fmt::format("{}[{}]", entry.path, k) : join_path(entry.path, item.name);
      if (is_list && takes_names) {
        if (item.kind != NodeKind::text) return wrong(entry, item, path, findings);
        numbers.push_back({item.text, 0.0});
        continue;
      }
      const bool is_integer = item.kind == NodeKind::integer;
      const Real value = is_integer ? static_cast<Real>(item.integer) : item.number;
      if ((!is_integer && item.kind != NodeKind::number) || !std::isfinite(value))
        return wrong(entry, item, path, findings);
      numbers.push_back({item.name, value});
    }
    return true;
  }
};

std::string numbers_text(const std::vector<NamedNumber>& numbers)
{
  std::string text;
  for (const NamedNumber& number : numbers)
    text +=
        fmt::format("{}{}{}", text.empty() ? "" : ", ", number.name.empty() ? "" : number.name + " = ", number.value);
  return text.empty() ? text : '[' + text + ']';
}

OwnForm numbers_field(std::vector<NamedNumber>& numbers, NumbersReader reader)
{
  return {std::string(reader.form),
      [&numbers, reader](const Entry& entry, Findings& findings) { return reader.read(entry, numbers, findings); },
      [&numbers] { return numbers_text(numbers); }};
}

constexpr Real stress_units[] = {1.0, 1e3, 1e6};
std::vector<std::string> stress_unit_words() { return {"Pa", "kPa", "MPa"}; }

int word_of_stress_unit(Real value)
{
  return static_cast<int>(std::ranges::find(stress_units, value) - std::begin(stress_units));
}

WordField stress_unit_field(Real& value)
{
  return {[&value] { return word_of_stress_unit(value); }, [&value](int word) { value = stress_units[word]; }};
}

std::vector<KeyInfo> keys_of_law_itself()
{
  return {
      {.path = "material.NAME.library",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].library.file; },
          .required = true,
          .meaning =
              "file of the shared library that has the law, relative to the case file. It is copied into the run "
              "folder. Loading a library runs its code: take one from people you trust"},
      {.path = "material.NAME.interface",
          .field = [](Case& c, std::size_t i) { return word_field(c.materials[i].library.interface); },
          .words = interface_words,
          .required = true,
          .meaning = interface_meanings()},
      {.path = "material.NAME.symbol",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].library.symbol; },
          .meaning = "name of the function in the library",
          .default_text =
              "the usual one of the interface: terp_law; umat_, umat or UMAT; esm_, esm or ESM; user_mod_, user_mod, "
              "User_Mod or USER_MOD"},
      {.path = "material.NAME.model_number",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].library.model_number; },
          .range = between(1.0, 1000.0),
          .meaning = "of a UDSM, whose library may have several laws: the number of this one, iMod",
          .default_text = "1"},
      {.path = "material.NAME.parameters",
          .field =
              [](Case& c, std::size_t i) {
                return numbers_field(c.materials[i].library.parameters,
                    {"numbers [a, b, ...], or with names { NAME = a, NAME = b }, in the order of the library", false,
                        false});
              },
          .meaning = "numbers that the law is given: PROPS of a UMAT. Names are for the reader; those of a native "
                     "library are looked up, in any order",
          .default_text = "none"},
      {.path = "material.NAME.state",
          .field =
              [](Case& c, std::size_t i) {
                return numbers_field(c.materials[i].library.state,
                    {"the number of state variables, a list of their names, or a table { NAME = value at t = 0 }; at "
                     "most 100. A name may have a unit behind it: \"p_0 [kPa]\"",
                        true, true});
              },
          .meaning =
              "what each point remembers for the law: STATEV of a UMAT, zero at t = 0 unless a value is given. A "
              "native library names its own, a UDSM says how many it has",
          .default_text = "none"},
  };
}

/// A key of which only the law of the material knows, once it was loaded.
template <class T>
OwnForm term_field(const MaterialCase& material, const char* form, T LawTerms::*term)
{
  const auto read = [](const Entry& entry, Findings& findings) {
    T value{};
    return store_value(entry, &value, findings);
  };
  const auto text = [&material, term] {
    const LawTerms* terms = material.from_library != nullptr ? terms_of(*material.from_library) : nullptr;
    return terms != nullptr && terms->*term != LawTerms{}.*term ? fmt::format("{}", terms->*term) : std::string();
  };
  return {form, read, text};
}

constexpr std::string_view plastic_strain = "material.NAME.plastic_strain", strength = "material.NAME.strength",
                           residual_strength = "material.NAME.residual_strength",
                           components = "material.NAME.components";

std::vector<KeyInfo> keys_of_terms()
{
  return {
      {.path = std::string(plastic_strain),
          .field = [](Case& c, std::size_t i) { return term_field(c.materials[i], "text", &LawTerms::plastic_strain); },
          .meaning = "name of the state variable that is the equivalent plastic strain: max_eps_eq_p, the audit of the "
                     "history, where the soil shears",
          .default_text = "eps_eq_p, if the law has a state variable of this name"},
      {.path = std::string(strength),
          .field = [](Case& c, std::size_t i) { return term_field(c.materials[i], "text", &LawTerms::strength); },
          .meaning = "name of the state variable that is the strength that is left, in the unit of `stress_unit`: the "
                     "field su, the audit of the history, named points. Its value at t = 0 is that of soil that has "
                     "not softened",
          .default_text = "not known"},
      {.path = std::string(residual_strength),
          .field = [](Case& c,
                       std::size_t i) { return term_field(c.materials[i], "a number", &LawTerms::residual_strength); },
          .unit = "Pa",
          .range = not_negative,
          .meaning = "what softening leaves of `strength`, for the share of the soil that has softened. The law is not "
                     "given it",
          .default_text = "not known: no share is reported"},
      {.path = std::string(components),
          .field = [](Case& c,
                       std::size_t i) { return term_field(c.materials[i], "an integer", &LawTerms::n_components); },
          .range = between(4.0, 6.0),
          .meaning = "of stress and strain that a UMAT or ESM is given, NTENS: 4, or 6 for a law of three dimensions "
                     "alone, whose 13 and 23 are then zero",
          .default_text = "4"},
  };
}

template <class T>
T given(const Node& root, const std::string& material, std::string_view path, T value)
{
  const Node* node = find_node(root, join_path(material, last_part(std::string(path))));
  if (node == nullptr) return value;
  const std::vector<KeyInfo> keys = keys_of_terms();
  Findings known;  // since the key was read
  store_value({*node, material, *std::ranges::find(keys, path, &KeyInfo::path)}, &value, known);
  return value;
}

LawTerms given_terms(const Node& root, const std::string& material)
{
  const LawTerms none;
  return {.plastic_strain = given(root, material, plastic_strain, none.plastic_strain),
      .strength = given(root, material, strength, none.strength),
      .residual_strength = given(root, material, residual_strength, none.residual_strength),
      .n_components = given(root, material, components, none.n_components)};
}

bool same_terms(const MaterialCase& a, const MaterialCase& b)
{
  const LawTerms *x = a.from_library != nullptr ? terms_of(*a.from_library) : nullptr,
                 *y = b.from_library != nullptr ? terms_of(*b.from_library) : nullptr;
  if (x == nullptr || y == nullptr) return true;
  const bool same_residual = x->residual_strength == y->residual_strength ||
                             (std::isnan(x->residual_strength) && std::isnan(y->residual_strength));
  return x->plastic_strain == y->plastic_strain && x->strength == y->strength && same_residual &&
         x->n_components == y->n_components;
}

std::vector<KeyInfo> keys_of_surroundings()
{
  return {
      {.path = "material.NAME.kinematics",
          .field = [](Case& c, std::size_t i) { return NameList{&c.materials[i].library.kinematics}; },
          .words = words_of_kinematics,
          .meaning =
              "what Terp keeps for a law that looks at it: STRAN, DFGRD0 and DFGRD1 of a UMAT. Left out, these are "
              "not a number. Each costs memory: 4 and 5 numbers per point",
          .default_text = "none"},
      {.path = "material.NAME.stress_unit",
          .field = [](Case& c, std::size_t i) { return stress_unit_field(c.materials[i].library.stress_unit); },
          .words = stress_unit_words,
          .meaning =
              "unit in which the library has its stresses; its `parameters` are given in the library's own units"},
      {.path = "material.NAME.porosity",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].library.porosity; },
          .range = between_open(0.0, 1.0),
          .meaning = "porosity that an ESM is told; left out, it is told a number that is none",
          .default_text = "not given"},
      {.path = "material.NAME.thread_safe",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].library.thread_safe; },
          .meaning =
              "whether several threads may call the law at the same time: true only of a law without SAVE, COMMON "
              "or static variables. A native library says it itself, and false "
              "outweighs that"},
  };
}

std::filesystem::path file_of(const Case& values, const MaterialCase& material)
{
  return path_of(values.folder, material.library.file);
}

bool is_row(const std::string& name)
{
  const RowTable any_point;
  return std::ranges::find(any_point.entries(), name, &RowInfo::name) != any_point.entries().end();
}

/// Names that results have already, of any point or of Terp's own laws: a state variable may not be another thing of
/// the same name.
void check_names_of_state(const MaterialCase& material, std::vector<Problem>& problems)
{
  for (const NamedNumber& number : material.library.state) {
    const auto fields = all_frame_fields();
    const auto taken = std::ranges::find(fields, number.name, &FrameField::name);
    const bool is_shared = number.name == "eps_eq_p";
    if ((taken == fields.end() || is_shared) && !number.name.starts_with("law_") && !is_row(number.name)) continue;
    problems.push_back({join_path(material_path(material), "state"),
        fmt::format("`{}` cannot be the name of a state variable", number.name),
        "Results have another quantity of this name (`terp list`), or it begins with law_. Give it another.",
        "library"});
  }
}

/// The number of a strength is taken in the unit of the stresses.
void check_unit_of_strength(const MaterialCase& material, std::vector<Problem>& problems)
{
  const auto& state = material.from_library->state;
  const std::string& name = terms_of(*material.from_library)->strength;
  const auto found = std::ranges::find(state, name, &StateInfo::name);
  if (name.empty() || found->unit == "-") return;
  const std::optional<NumberWithUnit> one = parse_quantity(fmt::format("1 {}", found->unit));
  const Real stress_unit = material.library.stress_unit;
  const bool is_stress = one && one->unit != nullptr && one->unit->of_key == "Pa";
  if (is_stress && one->value() == stress_unit) return;
  const std::string word = stress_unit_words()[static_cast<std::size_t>(word_of_stress_unit(stress_unit))];
  problems.push_back({join_path(material_path(material), "strength"),
      fmt::format("the strength `{}` is in {}, the stresses of the library in {}", name, found->unit, word),
      is_stress ? "A law has both in one unit. Correct `stress_unit`, or the unit of the state variable."
                : "Allowed: a state variable in the unit of `stress_unit`.",
      "library", false, {join_path(material_path(material), "stress_unit")}});
}

void check_components(const Node& root, const std::string& path, LawInterface interface, std::vector<Problem>& problems)
{
  const Index n = given_terms(root, path).n_components;
  if (n != 4 && n != 6)
    problems.push_back({join_path(path, "components"), fmt::format("a law cannot have {} components", n),
        "Allowed: 4 of plane strain, or 6.", "library"});
  else if (n == 6 && (interface == LawInterface::native || interface == LawInterface::udsm))
    problems.push_back({join_path(path, "components"),
        interface == LawInterface::native ? "a native library has 4 components" : "a UDSM has 6 components in any case",
        "Remove `components`.", "library", true});
}

void load_library(const Node& root, const Case& values, MaterialCase& material, std::vector<Problem>& problems)
{
  const std::string path = material_path(material);
  const bool takes_turns = find_node(root, join_path(path, "thread_safe")) != nullptr && !material.library.thread_safe;
  if (material.library.interface == LawInterface::native && !material.library.kinematics.empty())
    problems.push_back({join_path(path, "kinematics"), "a native library keeps what it needs itself",
        "Remove `kinematics`; a state variable can add up the strain increments.", "library", true});
  if (sets_state_in_first_call(material.library.interface) && !material.library.kinematics.empty())
    problems.push_back({join_path(path, "kinematics"),
        fmt::format("{} has no place for strain or deformation gradient",
            material.library.interface == LawInterface::esm ? "an ESM" : "a UDSM"),
        "Remove `kinematics`.", "library", true});
  if (material.library.interface != LawInterface::udsm && material.library.model_number != 1)
    problems.push_back({join_path(path, "model_number"), "only a UDSM has laws by number",
        "Remove `model_number`; `symbol` names another function of a library.", "library", true});
  if (material.library.interface != LawInterface::esm && !std::isnan(material.library.porosity))
    problems.push_back({join_path(path, "porosity"), "only an ESM is told a porosity",
        "Remove `porosity`, or give it as one of the `parameters`.", "library", true});
  check_components(root, path, material.library.interface, problems);
  try {
    material.from_library = load_user_law(
        material.name, values.folder, material.parameters, material.library, given_terms(root, path), takes_turns);
    check_names_of_state(material, problems);
    check_unit_of_strength(material, problems);
  } catch (const InputError& error) {
    for (Problem problem : error.problems()) {
      problem.key = join_path(path, problem.key);
      problem.others = {path};
      problems.push_back(std::move(problem));
    }
  }
}

/// Whether an ESM of these materials sets the state of the soil `name` in its first call.
bool sets_state_in_first_call(const Case& values, const std::string& name)
{
  return std::ranges::any_of(values.materials, [&](const MaterialCase& m) {
    return m.called() == name && m.model == "library" && terp::sets_state_in_first_call(m.library.interface) &&
           !m.library.state.empty();
  });
}

}  // namespace

std::vector<KeyInfo> library_keys()
{
  std::vector<KeyInfo> keys = keys_of_law_itself();
  std::ranges::move(keys_of_terms(), std::back_inserter(keys));
  std::ranges::move(keys_of_surroundings(), std::back_inserter(keys));
  return keys;
}

void load_libraries(const Node& root, Case& values, std::vector<Problem>& problems)
{
  for (MaterialCase& material : values.materials) {
    const MaterialType* law = find_material(material.model);
    std::error_code ignored;
    const auto is_of_material = [&](const Problem& problem) {
      return problem.key.starts_with(join_path("material", material.called()));
    };
    if (law == nullptr || !law->by_library || material.library.file.empty() ||
        std::ranges::any_of(problems, is_of_material) ||
        !std::filesystem::is_regular_file(file_of(values, material), ignored) ||
        std::ranges::any_of(material.parameters, [](Real value) { return std::isnan(value); }))
      continue;
    load_library(root, values, material, problems);
  }
}

void check_libraries_of_stage(const Case& before, const Case& now, std::vector<Problem>& problems)
{
  for (std::size_t m = 0; m < std::min(before.materials.size(), now.materials.size()); ++m) {
    const LibraryCase &a = before.materials[m].library, &b = now.materials[m].library;
    const auto same = [](const NamedNumber& x, const NamedNumber& y) { return x.name == y.name && x.value == y.value; };
    const bool same_porosity = a.porosity == b.porosity || (std::isnan(a.porosity) && std::isnan(b.porosity));
    if (a.file == b.file && a.interface == b.interface && a.symbol == b.symbol && a.model_number == b.model_number &&
        a.kinematics == b.kinematics && a.stress_unit == b.stress_unit && a.thread_safe == b.thread_safe &&
        same_porosity && same_terms(before.materials[m], now.materials[m]) &&
        std::ranges::equal(a.state, b.state, same))
      continue;
    problems.push_back({join_path("material", now.materials[m].name), "a stage cannot change where a law comes from",
        "Its `parameters` and moduli may change; all else that the law is given is that of the whole run.", "stage.set",
        true});
  }
}

void check_first_calls(const Case& before, const Case& now, std::size_t stage, std::vector<Problem>& problems)
{
  const Scheme* scheme = find_scheme(now.scheme);
  if (scheme == nullptr || !scheme->keeps_gauss_values) return;
  const std::vector<std::string>& placed = now.stages[stage].place;
  for (std::size_t b = 0; b < now.bodies.size(); ++b) {
    const BodyCase& body = now.bodies[b];
    const bool is_placed = !body.name.empty() && std::ranges::find(placed, body.name) != placed.end();
    if (!is_placed && body.material == before.bodies[b].material) continue;
    const bool has_company = std::ranges::any_of(before.bodies, [&](const BodyCase& other) {
      return &other != &before.bodies[b] && other.is_there && other.material == body.material;
    });
    if (!has_company || !sets_state_in_first_call(now, body.material)) continue;
    problems.push_back({fmt::format("stage[{}].{}", stage, is_placed ? "place" : "set"),
        fmt::format("soil of the ESM `{}` cannot come to soil of it that is there", body.material),
        fmt::format("An ESM sets the state of a point in its first call, and {} has one call for all points of a cell. "
                    "Give the body a\nmaterial of its own, or use scheme = \"mpm_gp\".",
            now.scheme),
        "library", true});
  }
}

}  // namespace terp
