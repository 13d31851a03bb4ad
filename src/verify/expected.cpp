// First each table is read entry by entry. Then quantities and runs are checked against each other. No key that a kind
// ignores is taken, because the author may rely on it.
#include "verify/expected.hpp"

#include "math/closest.hpp"
#include "io/case/case_file.hpp"
#include "io/case/other_files.hpp"
#include "io/case/render.hpp"
#include "io/case/values.hpp"
#include "run/stability/bisection.hpp"
#include "os/read_file.hpp"

#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

using Names = std::vector<std::string>;

const Names quantity_keys = {"name", "kind", "value", "reduce", "reference", "where", "scale", "time", "from", "to",
    "threshold", "at", "runs", "tolerance", "relative", "at_least", "at_most", "of", "over", "unit", "source", "red",
    "as", "shown", "differences", "red_runs", "order", "regression"};
const Names run_keys = {"name", "case", "schemes", "set", "constants", "long", "seconds", "stability", "least_depth"};
const Names kind_words = {
    "field", "point", "ledger", "summary", "formula", "order", "footing", "extrapolated", "mesh_error"};
const Names reduce_words = {
    "rms_error", "max_error", "mean", "sum", "max", "min", "at", "last", "period", "frequency", "arrival"};

class TableReader {
 public:
  TableReader(const Expected& file, const Node& table, const Names& allowed) : file_(file), table_(table)
  {
    if (table.kind != NodeKind::table)
      refuse(file, table.value, "a table must stand here", "Got " + describe_value(table) + ".");
    for (const Node& item : table.items)
      if (std::ranges::find(allowed, item.name) == allowed.end()) unknown(item.key, item.name, allowed);
  }

  std::string text(const char* name, bool required = false) const
  {
    const Node* item = find(name, required);
    if (item == nullptr) return "";
    if (item->kind != NodeKind::text) wrong(*item, "text in quotes");
    return item->text;
  }
  /// A text for tables and progress lines.
  std::string label(const char* name, bool required = false) const
  {
    const std::string got = text(name, required);
    if (std::ranges::any_of(got, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }))
      wrong(*find(name, false), "one line of text without control characters");
    return got;
  }
  bool flag(const char* name) const
  {
    const Node* item = find(name, false);
    if (item != nullptr && item->kind != NodeKind::boolean) wrong(*item, "true or false");
    return item != nullptr && item->boolean;
  }
  Names texts(const char* name) const
  {
    Names list;
    const Node* item = find(name, false);
    if (item == nullptr) return list;
    if (item->kind != NodeKind::list) wrong(*item, "a list of texts");
    for (const Node& entry : item->items) {
      if (entry.kind != NodeKind::text) wrong(entry, "text in quotes");
      list.push_back(entry.text);
    }
    return list;
  }
  Formula formula(const char* name, bool required = false) const
  {
    const Node* item = find(name, required);
    return item == nullptr ? Formula{} : to_formula(*item);
  }
  Formula to_formula(const Node& item) const
  {
    if (item.kind == NodeKind::text && !item.text.empty()) return {item.text, item.value};
    if (item.kind == NodeKind::integer) return {fmt::format("{}", item.integer), item.value};
    if (item.kind == NodeKind::number) return {fmt::format("{}", item.number), item.value};
    wrong(item, "a number, or a formula in quotes");
  }
  int word(const char* name, const Names& words, int fallback) const
  {
    const Node* item = find(name, false);
    if (item == nullptr) return fallback;
    const std::string got = text(name);
    const auto found = std::ranges::find(words, got);
    if (found == words.end()) unknown(item->value, got, words);
    return static_cast<int>(found - words.begin());
  }
  const Node* find(const char* name, bool required) const
  {
    const Node* item = find_item(table_, name);
    if (item == nullptr && required)
      refuse(file_, table_.value, fmt::format("`{}` is missing", name), "See docs/verification_cases.md.");
    return item;
  }
  [[noreturn]] void wrong(const Node& item, const std::string& wanted) const
  {
    refuse(file_, item.value, fmt::format("`{}` must be {}", item.name, wanted), "Got " + describe_value(item) + ".");
  }
  [[noreturn]] void unknown(Place place, const std::string& got, const Names& words) const
  {
    refuse(file_, place, fmt::format("`{}` is not known here", got),
        did_you_mean(got, words) + fmt::format("Allowed: {}", fmt::join(words, ", ")));
  }

 private:
  const Expected& file_;
  const Node& table_;
};

/// A name that formulas may use; some names are taken.
void check_word(const Expected& file, Place place, const std::string& name)
{
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const auto is_part = [&](char c) { return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; };
  if (name.empty() || !is_letter(name.front()) || !std::ranges::all_of(name, is_part))
    refuse(file, place, fmt::format("`{}` is no name for a formula", name),
        "Letters, digits and _ make one, a letter first.");
  for (const char* taken : {"pi", "end", "dt", "gci", "factor", "stable_at", "not_stable_at"})
    if (name == taken)
      refuse(file, place, fmt::format("`{}` has a meaning of its own in formulas", name),
          "Take another name; see docs/verification_cases.md.");
}

std::vector<Constant> read_constants(const Expected& file, const Node* table)
{
  std::vector<Constant> constants;
  if (table == nullptr) return constants;
  Names any;
  for (const Node& item : table->items) any.push_back(item.name);
  const TableReader reader(file, *table, any);
  for (const Node& item : table->items) {
    check_word(file, item.key, item.name);
    Constant& c = constants.emplace_back();
    c.name = item.name;
    if (item.kind == NodeKind::table) {
      c.key = TableReader(file, item, {"key"}).text("key", true);
      c.formula.place = item.value;
    } else {
      c.formula = reader.to_formula(item);
    }
  }
  return constants;
}

/// [from, to, tolerance] of a search for a factor of safety, within the limits of `terp stability`.
std::vector<Real> read_stability(const TableReader& reader, const Node& bounds)
{
  const auto is_number = [](const Node& n) { return n.kind == NodeKind::number || n.kind == NodeKind::integer; };
  if (bounds.kind != NodeKind::list || bounds.items.size() != 3 || !std::ranges::all_of(bounds.items, is_number))
    reader.wrong(bounds, "[from, to, tolerance] of the factor");
  std::vector<Real> values;
  for (const Node& n : bounds.items)
    values.push_back(n.kind == NodeKind::integer ? static_cast<Real>(n.integer) : n.number);
  if (!(least_factor <= values[0] && values[0] < values[1] && values[1] <= greatest_factor &&
          least_tolerance <= values[2] && values[2] <= greatest_tolerance))
    reader.wrong(bounds,
        fmt::format("[from, to, tolerance] of the factor: {:g} <= from < to <= {:g}, tolerance from {:g} to {:g}",
            least_factor, greatest_factor, least_tolerance, greatest_tolerance));
  return values;
}

/// `long` is of all schemes of a run, or a list of some.
void read_long(const Expected& file, const TableReader& reader, const Node& table, Variant& v)
{
  const Node* item = find_item(table, "long");
  if (item == nullptr || item->kind != NodeKind::list) {
    v.is_long = reader.flag("long");
    return;
  }
  v.long_schemes = reader.texts("long");
  for (std::size_t k = 0; k < v.long_schemes.size(); ++k)
    if (std::ranges::find(v.schemes, v.long_schemes[k]) == v.schemes.end())
      refuse(file, item->items[k].value, fmt::format("`{}` is not in `schemes` of this run", v.long_schemes[k]),
          "Name those of its schemes whose run is long, or write `long = true` for all.");
}

Variant read_variant(const Expected& file, const Node& table)
{
  const TableReader reader(file, table, run_keys);
  Variant v{.name = reader.label("name"),
      .case_file = reader.text("case"),
      .schemes = reader.texts("schemes"),
      .set = reader.texts("set"),
      .constants = read_constants(file, find_item(table, "constants"))};
  v.place = table.value;
  read_long(file, reader, table, v);
  for (std::size_t k = 0; k < v.schemes.size(); ++k)
    if (std::find(v.schemes.begin(), v.schemes.begin() + static_cast<std::ptrdiff_t>(k), v.schemes[k]) !=
        v.schemes.begin() + static_cast<std::ptrdiff_t>(k))
      refuse(file, find_item(table, "schemes")->items[k].value,
          fmt::format("`{}` is in `schemes` already", v.schemes[k]), "Each scheme is one run.");
  if (const Node* bounds = find_item(table, "stability")) v.stability = read_stability(reader, *bounds);
  if (v.case_file.empty()) v.case_file = "case.toml";
  const auto read_number = [&](const char* key, double& value, const char* allowed) {
    const Node* node = find_item(table, key);
    if (node == nullptr) return;
    value = node->kind == NodeKind::integer  ? static_cast<double>(node->integer)
            : node->kind == NodeKind::number ? node->number
                                             : -1.0;
    if (!(value >= 0.0)) reader.wrong(*node, allowed);
  };
  read_number("seconds", v.seconds, "a number of seconds, 0 or more");
  read_number("least_depth", v.least_depth, "a depth in m, 0 or more");
  return v;
}

Reduce default_reduce(QuantityKind kind)
{
  switch (kind) {
    case QuantityKind::field: return Reduce::rms_error;
    case QuantityKind::summary:
    case QuantityKind::formula:
    case QuantityKind::extrapolated:
    case QuantityKind::mesh_error: return Reduce::last;
    default: return Reduce::at;
  }
}

/// A bound on one side, or a reference with a tolerance.
void check_judgement(const Expected& file, const Quantity& q)
{
  const int n_bounds = q.tolerance.given() + q.relative.given() + q.at_least.given() + q.at_most.given();
  if (n_bounds == 0 && !q.as.empty() && !compares_runs(q)) return;
  if (n_bounds != 1)
    refuse(file, q.place, "one of `tolerance`, `relative`, `at_least`, `at_most` must be given",
        fmt::format("Got {}.", n_bounds));
  if ((q.tolerance.given() || q.relative.given()) && !q.reference.given())
    refuse(file, q.place, "`reference` is missing", "A tolerance needs it.");
  if (is_error(q.reduce) && q.relative.given())
    refuse(file, q.relative.place, "an error takes `tolerance`, not `relative`", "Use `scale`.");
  if (q.source.empty()) refuse(file, q.place, "`source` is missing", "Say where the reference comes from.");
}

/// A row that is no pass needs its reason.
void check_regression(const TableReader& reader, const Quantity& q)
{
  const Node* item = reader.find("regression", false);
  if (item != nullptr && q.regression.empty()) reader.wrong(*item, "why no value from outside Terp holds it");
}

void read_place(const TableReader& reader, Quantity& q)
{
  const Node* at = reader.find("at", q.kind == QuantityKind::point);
  if (at == nullptr) return;
  if (at->kind != NodeKind::list || at->items.size() != 2) reader.wrong(*at, "a place: [x, y] in m");
  for (std::size_t d = 0; d < 2; ++d) q.at[d] = reader.to_formula(at->items[d]);
}

bool is_series(const Quantity& q)
{
  return q.kind == QuantityKind::point || q.kind == QuantityKind::ledger || q.kind == QuantityKind::footing;
}

struct KeyUse {
  const char* key;
  bool (*has)(const Quantity&);
  const char* whose;  ///< "`time` is ..."
};

const KeyUse key_uses[] = {
    {"value", [](const Quantity& q) { return !compares_runs(q); },
        "not for order, extrapolated, mesh_error, which take the numbers of the quantity in `of`"},
    {"as", [](const Quantity& q) { return !compares_runs(q); }, "not for order, extrapolated, mesh_error"},
    {"reduce", [](const Quantity& q) { return q.kind == QuantityKind::field || is_series(q); },
        "for field, point, ledger, footing: the other kinds are one number already"},
    {"where", [](const Quantity& q) { return q.kind == QuantityKind::field; }, "for the points of a field"},
    {"at", [](const Quantity& q) { return q.kind == QuantityKind::point; },
        "for a point; points of a field are chosen by `where`"},
    {"time",
        [](const Quantity& q) { return q.kind == QuantityKind::field || (is_series(q) && q.reduce == Reduce::at); },
        "for a field, and for a series with reduce = \"at\""},
    {"from", is_series, "for series: point, ledger, footing"},
    {"to", is_series, "for series: point, ledger, footing"},
    {"threshold", [](const Quantity& q) { return is_series(q) && q.reduce == Reduce::arrival; },
        "for a series with reduce = \"arrival\""},
    {"scale", [](const Quantity& q) { return !compares_runs(q) && is_error(q.reduce); },
        "for reduce = \"rms_error\" or \"max_error\""},
    {"of", compares_runs, "for order, extrapolated, mesh_error"},
    {"over", compares_runs, "for order, extrapolated, mesh_error"},
    {"differences", [](const Quantity& q) { return q.kind == QuantityKind::order; }, "for order"},
    {"order", [](const Quantity& q) { return q.kind == QuantityKind::extrapolated; }, "for extrapolated"},
    {"red_runs", [](const Quantity& q) { return !q.red.empty(); }, "for a quantity that is `red`"},
    {"regression", [](const Quantity& q) { return !is_auxiliary(q); }, "for a quantity that is judged"},
};

void check_uses(const Expected& file, const Node& table, const Quantity& q)
{
  for (const KeyUse& use : key_uses)
    if (const Node* item = find_item(table, use.key); item != nullptr && !use.has(q))
      refuse(file, item->key,
          fmt::format("`{}` has no effect on a quantity of kind `{}` here", use.key,
              kind_words[static_cast<std::size_t>(q.kind)]),
          fmt::format("It is {}.", use.whose));
  const bool of_times = q.reduce == Reduce::at || q.reduce == Reduce::last || q.reduce == Reduce::period ||
                        q.reduce == Reduce::frequency || q.reduce == Reduce::arrival;
  if (q.kind == QuantityKind::field && of_times)
    refuse(file, find_item(table, "reduce")->value,
        fmt::format("a field has no `{}`", reduce_words[static_cast<std::size_t>(q.reduce)]),
        "It is at one time. Allowed: rms_error, max_error, mean, sum, max, min. A curve over time is a point, ledger "
        "or footing.");
}

Quantity read_quantity(const Expected& file, const Node& table)
{
  const TableReader reader(file, table, quantity_keys);
  Quantity q{.name = reader.label("name", true),
      .unit = reader.text("unit"),
      .source = reader.text("source"),
      .shown = reader.text("shown"),
      .red = reader.text("red"),
      .regression = reader.text("regression")};
  q.place = table.value;
  q.differences = reader.flag("differences");
  q.kind = static_cast<QuantityKind>(reader.word("kind", kind_words, 0));
  q.reduce = static_cast<Reduce>(reader.word("reduce", reduce_words, static_cast<int>(default_reduce(q.kind))));
  q.value = reader.formula("value", !compares_runs(q));
  q.reference = reader.formula("reference"), q.where = reader.formula("where"), q.scale = reader.formula("scale");
  q.time = reader.formula("time"), q.from = reader.formula("from"), q.to = reader.formula("to");
  q.threshold = reader.formula("threshold", q.reduce == Reduce::arrival);
  q.tolerance = reader.formula("tolerance"), q.relative = reader.formula("relative");
  q.at_least = reader.formula("at_least"), q.at_most = reader.formula("at_most");
  q.as = reader.text("as");
  q.order = reader.formula("order");
  if (const Node* as = find_item(table, "as")) check_word(file, as->value, q.as);
  q.of = reader.text("of", compares_runs(q)), q.over = reader.text("over", compares_runs(q));
  q.runs = reader.texts("runs");
  q.red_runs = reader.texts("red_runs");
  check_uses(file, table, q);
  read_place(reader, q);
  check_judgement(file, q);
  check_regression(reader, q);
  return q;
}

bool share_a_run(const Names& a, const Names& b)  // none named: all
{
  return a.empty() || std::ranges::any_of(a, [&](const std::string& run) { return names_run(b, run); });
}

/// A name given by `as` means one number in a run.
void check_as(const Expected& file)
{
  const auto is_constant = [](const std::vector<Constant>& constants, const std::string& name) {
    return std::ranges::any_of(constants, [&](const Constant& c) { return c.name == name; });
  };
  for (auto q = file.quantities.begin(); q != file.quantities.end(); ++q) {
    if (q->as.empty()) continue;
    const auto same = [&](const Quantity& other) { return other.as == q->as && share_a_run(other.runs, q->runs); };
    if (std::any_of(file.quantities.begin(), q, same))
      refuse(file, q->place, fmt::format("there are two quantities with as = \"{}\" in one run", q->as),
          "Formulas that speak of it would mean the last.");
    if (is_constant(file.constants, q->as) ||
        std::ranges::any_of(file.variants, [&](const Variant& v) { return is_constant(v.constants, q->as); }))
      refuse(file, q->place, fmt::format("as = \"{}\" is a constant already", q->as), "Take another name.");
  }
}

/// Quantities of one name must differ in their runs. `of` means all rows of a name, so there the name must belong to
/// one quantity.
void check_quantity_names(const Expected& file)
{
  for (auto q = file.quantities.begin(); q != file.quantities.end(); ++q) {
    const auto is_compared = [&](const Quantity& other) { return other.of == q->name; };
    for (auto earlier = file.quantities.begin(); earlier != q; ++earlier) {
      if (earlier->name != q->name) continue;
      if (share_a_run(earlier->runs, q->runs))
        refuse(file, q->place, fmt::format("there are two quantities `{}` of one run", q->name),
            "Each needs a name of its own, or `runs` that the other has not.");
      if (std::ranges::any_of(file.quantities, is_compared))
        refuse(file, q->place, fmt::format("there are two quantities `{}`, and an `of` names it", q->name),
            "Give each a name of its own: `of` would mix their numbers.");
    }
  }
}

/// Runs have unique names; those in `runs` and `of` must exist.
void check_names(const Expected& file)
{
  Names runs, quantities;
  for (const Variant& v : file.variants) {
    if (std::ranges::find(runs, v.name) != runs.end())
      refuse(file, v.place,
          v.name.empty() ? "more than one run has no `name`" : fmt::format("there are two runs `{}`", v.name),
          "Where there is more than one, each needs a name of its own: the rows are told apart by it.");
    runs.push_back(v.name);
  }
  Names red_runs = runs;
  for (const Variant& v : file.variants)
    for (const std::string& scheme : v.schemes)
      for (const std::string& name : {scheme, v.name + ", " + scheme})
        if (std::ranges::find(red_runs, name) == red_runs.end()) red_runs.push_back(name);
  for (const Quantity& q : file.quantities) quantities.push_back(q.name);
  const auto check = [&](const Quantity& q, const std::string& name, const Names& known, const char* what) {
    if (std::ranges::find(known, name) == known.end())
      refuse(file, q.place, fmt::format("there is no {} `{}`", what, name),
          fmt::format("There are: {}", fmt::join(known, ", ")));
  };
  for (const Quantity& q : file.quantities) {
    for (const std::string& run : q.runs) check(q, run, runs, "run");
    for (const std::string& run : q.red_runs) check(q, run, red_runs, "run");
    if (!compares_runs(q)) continue;
    check(q, q.of, quantities, "quantity");
    const auto compared = [&](const Quantity& other) { return other.name == q.of && compares_runs(other); };
    if (std::ranges::any_of(file.quantities, compared))
      refuse(file, q.place, fmt::format("`of` names `{}`, which compares runs itself", q.of),
          "Name a quantity that each run measures.");
  }
}

/// With too few runs a quantity would have no row, and nobody would notice.
void check_run_counts(const Expected& file)
{
  for (const Quantity& q : file.quantities) {
    if (!compares_runs(q)) continue;
    std::map<std::string, std::ptrdiff_t> n_runs{
        {"", 0}};  // of each scheme; "": that of the case, which may be any of them
    for (const Quantity& measured : file.quantities)
      for (const Variant& v : file.variants)
        if (measured.name == q.of && names_run(measured.runs, v.name) && names_run(q.runs, v.name))
          for (const std::string& scheme : v.schemes.empty() ? Names{""} : v.schemes) ++n_runs[scheme];
    std::ptrdiff_t most = 0;
    for (const auto& [scheme, n] : n_runs) most = std::max(most, n + (scheme.empty() ? 0 : n_runs[""]));
    if (most < least_runs(q))
      refuse(file, q.place, fmt::format("`{}` needs {} runs of one scheme", q.name, least_runs(q)),
          fmt::format("`{}` is measured in {}.", q.of, most));
  }
}

const std::vector<Node>& tables(const Expected& file, const Node& root, const char* name)
{
  static const std::vector<Node> none;
  const Node* list = find_item(root, name);
  if (list == nullptr) return none;
  if (list->kind != NodeKind::list) refuse(file, list->value, fmt::format("write [[{}]], once for each", name), "");
  return list->items;
}

}  // namespace

void refuse(const Expected& expected, Place place, const std::string& what, const std::string& detail)
{
  throw CaseError(render_at(expected.path, expected.text, place, {"", what, detail, ""}));
}

Expected read_expected(const std::string& path)
{
  Expected file{.path = path};
  if (const std::string fault = fault_of_file(path); !fault.empty())
    throw CaseError(fmt::format(
        "error: {}: {}\n  A verification case is a folder with case.toml and expected.toml.\n", path, fault));
  file.text = read_file(path);
  try {
    const Node root = parse_toml(file.text);
    const TableReader reader(file, root, {"title", "constants", "run", "quantity"});
    file.title = reader.text("title", true);
    file.constants = read_constants(file, find_item(root, "constants"));
    for (const Node& table : tables(file, root, "run")) file.variants.push_back(read_variant(file, table));
    if (file.variants.empty()) file.variants.push_back({.case_file = "case.toml"});
    for (const Node& table : tables(file, root, "quantity")) file.quantities.push_back(read_quantity(file, table));
    check_names(file);
    check_quantity_names(file);
    check_as(file);
    check_run_counts(file);
  } catch (const SyntaxError& error) {
    refuse(file, error.place, "this is not valid TOML", error.what());
  }
  return file;
}

}  // namespace terp
