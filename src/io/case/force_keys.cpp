// The keys of [forces] and [initial], and how the formulas of a body force are read.

#include "io/case/document.hpp"
#include "io/case/expression.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/units.hpp"
#include "io/case/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string_view>

namespace terp {
namespace {

std::vector<std::string> stress_words() { return {"none", "k0", "equilibrium"}; }

constexpr std::size_t most_formulas = 32;  // of a body force

/// Whether a formula of these names, of which the fifth is t, speaks of t.
bool speaks_of_time(const std::string& formula, std::vector<std::string> names)
{
  names.erase(names.begin() + 4);
  try {
    const Expression steady(formula, names, {});
    return false;
  } catch (const ExpressionError&) {
    return true;
  }
}

/// Formulas by name, in the order of the file, each of x, y, x0, y0, t and of those above it. bx and by are the force.
bool read_body_force(const Entry& entry, Findings& findings, BodyForceCase& body)
{
  constexpr std::string_view form = "a table of formulas of x, y, x0, y0 and t, with bx and by among them";
  const Node& table = entry.node;
  const char* missing = find_item(table, "bx") == nullptr ? "bx" : find_item(table, "by") == nullptr ? "by" : nullptr;
  if (table.kind != NodeKind::table)
    return refuse(entry, entry.path, fmt::format("`body` must be {}", form),
        fmt::format("Got {}.", describe_value(table)), findings);
  if (missing != nullptr)
    return refuse(entry, entry.path, fmt::format("`body` has no `{}`", missing),
        fmt::format("It must be {}. Give {} = 0 where there is no such force.", form, missing), findings);
  std::vector<std::string> names{"x", "y", "x0", "y0", "t"};
  std::vector<Expression> parts;
  std::string text;
  if (table.items.size() > most_formulas)
    return refuse(entry, entry.path, fmt::format("`body` has more than {} formulas", most_formulas),
        "Put some of them into one.", findings);
  for (const Node& item : table.items) {
    const std::string path = join_path(entry.path, item.name);
    const std::optional<Real> number = number_of(item, entry.key.unit);
    if (!number && item.kind != NodeKind::text)
      return refuse(entry, path, fmt::format("`{}` must be a formula", item.name),
          fmt::format("Got {}.", describe_value(item)), findings);
    const std::string formula = number ? fmt::format("{}", *number) : item.text;
    try {
      if (std::ranges::find(names, item.name) != names.end())
        throw ExpressionError("It is the name of a variable. Give it another name.");
      parts.emplace_back(formula, names, std::map<std::string, Real>{});
    } catch (const ExpressionError& error) {
      return refuse(entry, path, fmt::format("`{}` is not a formula of {}", item.name, plain_list(names)),
          fmt::format("{}\nGot \"{}\"; places in m, t in s, bx and by in m/s^2.", error.what(), formula), findings);
    }
    body.changes = body.changes || speaks_of_time(formula, names);
    names.push_back(item.name);
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", item.name, quoted_list({formula}));
  }
  const auto number_of_name = [&](std::string_view name) { return std::ranges::find(names, name) - names.begin(); };
  const std::array component{number_of_name("bx"), number_of_name("by")};
  body.text = "{ " + text + " }";
  body.at = [parts, component](Vec<2> x, Vec<2> x_initial, Real time) -> Vec<2> {
    constexpr std::size_t n_variables = 5;
    std::array<Real, n_variables + most_formulas> values{x[0], x[1], x_initial[0], x_initial[1], time};
    for (std::size_t k = 0; k < parts.size(); ++k)
      values[n_variables + k] = parts[k](std::span<const Real>(values.data(), n_variables + k));
    return {values[static_cast<std::size_t>(component[0])], values[static_cast<std::size_t>(component[1])]};
  };
  return true;
}

}  // namespace

std::vector<KeyInfo> force_keys()
{
  return {
      {.path = "forces.gravity",
          .field = [](Case& c, std::size_t) { return &c.forces.gravity; },
          .unit = "m/s^2",
          .in_stage = true,
          .meaning = "acceleration of gravity, acts fully from t = 0; over the `ramp` of a stage that changes it"},
      {.path = "forces.body",
          .field =
              [](Case& c, std::size_t) {
                BodyForceCase& body = c.forces.body;
                return OwnForm{"a table of formulas with bx and by",
                    [&body](const Entry& entry, Findings& findings) { return read_body_force(entry, findings, body); },
                    [&body] { return body.text; }};
              },
          .unit = "m/s^2",
          .meaning = "force per mass on each point beside gravity: formulas bx and by of its place x, y and its place "
                     "at t = 0, x0, y0 [m], of the time t [s], and of formulas with other names above them. It is no "
                     "overburden, and its work is in load_work (docs/loads.md)",
          .equation = "f_i += sum_p m_p N_i(x_p) b(x_p, x_p0, t)"},
      {.path = "forces.damping.local",
          .field = [](Case& c, std::size_t) { return &c.forces.local_damping; },
          .range = {0.0, 1.0, false, true},
          .in_stage = true,
          .meaning = "local (Cundall) damping alpha at the nodes (reading R13); free fall sees g (1 - alpha)",
          .equation = "R_i <- R_i - alpha |R_i| sign(v_i)"},
      {.path = "forces.damping.averaging_time",
          .field = [](Case& c, std::size_t) { return &c.forces.averaging_time; },
          .unit = "s",
          .range = not_negative,
          .meaning = "local damping acts on a running mean of the out-of-balance force over this time, so that noise "
                     "from points that cross cells does not brake; 0: on the force of the step",
          .equation = "M_i <- M_i + (R_i - M_i) min(dt / time, 1),  R_i <- R_i - alpha |M_i| sign(v_i)"},
      {.path = "forces.damping.viscous",
          .field = [](Case& c, std::size_t) { return &c.forces.viscous_damping; },
          .unit = "1/s",
          .range = not_negative,
          .in_stage = true,
          .meaning = "damping c in proportion to the nodal mass (reading R13)",
          .equation = "R_i <- R_i - c m_i v_i"},

      {.path = "initial.stress",
          .field = [](Case& c, std::size_t) { return word_field(c.initial.stress); },
          .words = stress_words,
          .meaning =
              "stress at t = 0 (reading R14): none, from the overburden (k0), or that with which the section rests "
              "as it is drawn, sought with small displacements from that of k0 where there is water or a material "
              "gives its k0, else from none (equilibrium)",
          .default_text = "\"equilibrium\" in a case with gravity and [water] or [flood], else \"none\""},
      {.path = "initial.k0",
          .field = [](Case& c, std::size_t) { return &c.initial.k0; },
          .range = not_negative,
          .usual = {0.2, 4.0},
          .meaning = "horizontal over vertical effective stress, for stress = \"k0\", and \"equilibrium\" where it "
                     "begins with that",
          .default_text = "1; of soil with friction_angle and yield_stress (1 - sin phi) OCR^(sin phi)"},
      {.path = "initial.damping",
          .field = [](Case& c, std::size_t) { return &c.initial.damping; },
          .range = {0.0, 1.0, false, true},
          .meaning = "local damping while seeking equilibrium, beside the damping that follows the slowest motion"},
      {.path = "initial.limit",
          .field = [](Case& c, std::size_t) { return &c.initial.limit; },
          .range = between_open(0.0, 1.0),
          .meaning =
              "out-of-balance force over weight below which the soil may be at rest; docs/methods.md says what else"},
      {.path = "initial.max_steps",
          .field = [](Case& c, std::size_t) { return &c.initial.max_steps; },
          .range = {1.0},
          .meaning = "steps after which the search for equilibrium gives up"},
  };
}

}  // namespace terp
