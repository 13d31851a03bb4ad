// `known` comes last: its values are those of the soil, and become scores of the normal field by the distribution and
// the mean at their place. So that mean may follow from the place alone.

#include "io/case/random_kind.hpp"

#include "math/errors.hpp"
#include "io/case/key_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real most_seed = 2147483647.0;
constexpr std::size_t most_known = 1000;  // the cost of conditioning grows with its cube
constexpr double most_nodes = 2e7;        // 0.2 GB, seconds

struct RandomText {
  GaussianFieldCase field;
  Index seed = 0, realisation = 0, number = 0;
  std::string distribution = "lognormal", correlation = random_correlations().front();
  Real cov = 0.0;
};

struct RandomKey {
  std::string_view name, unit;
  Range range, usual;
  bool required;
  Field (*field)(RandomText&);
  std::string_view meaning;
};

constexpr Range whole{0.0, most_seed};

// Usual values: docs/probability.md.
const RandomKey random_keys[] = {
    {"cov", "-", {0.0, 3.0, true, false}, between(0.02, 1.0), true, [](RandomText& t) -> Field { return &t.cov; },
        "coefficient of variation"},
    {"theta", "m", positive, between(0.05, 200.0), true, [](RandomText& t) -> Field { return &t.field.scale; },
        "scales of fluctuation along x and y"},
    {"box", "m", any_number, any_number, true,
        [](RandomText& t) -> Field {
          return BoxCorners{&t.field.low, &t.field.high};
        },
        "[[x, y], [x, y]], where the field has values"},
    {"seed", "-", whole, any_number, false, [](RandomText& t) -> Field { return &t.seed; }, "of the random numbers"},
    {"realisation", "-", whole, any_number, false, [](RandomText& t) -> Field { return &t.realisation; },
        "number of the draw"},
    {"field", "-", {0.0, 1e6}, any_number, false, [](RandomText& t) -> Field { return &t.number; },
        "number of the field: fields of one number are the same"},
    {"distribution", "", any_number, any_number, false, [](RandomText& t) -> Field { return &t.distribution; },
        "lognormal or normal"},
    {"correlation", "", any_number, any_number, false, [](RandomText& t) -> Field { return &t.correlation; },
        "how two places go together, as below"},
};
constexpr std::string_view own_keys[] = {"mean", "known", "mix"};

std::vector<std::string> names_of_keys()
{
  std::vector<std::string> names(std::begin(own_keys), std::end(own_keys));
  for (const RandomKey& key : random_keys) names.emplace_back(key.name);
  return names;
}

bool read_keys(const Node& table, const FieldContext& context, RandomText& text)
{
  bool good = true;
  for (const RandomKey& info : random_keys) {
    const Node* item = find_item(table, info.name);
    const std::string path = join_path(context.entry.path, info.name);
    if (item == nullptr) {
      if (info.required)
        refuse_field(context, context.entry.path, fmt::format("`random` needs `{}`", info.name),
            fmt::format("It is {}{}.", info.meaning, info.unit == "-" ? "" : fmt::format(" [{}]", info.unit)));
      good = good && !info.required;
      continue;
    }
    KeyInfo key = key_like(context.entry.key, info.unit, info.range, info.usual);
    key.field = {}, key.path = info.name;
    if (info.name == "distribution") key.words = random_distributions;
    if (info.name == "correlation") key.words = random_correlations;
    const std::size_t before = context.findings.problems.size();
    const Field field = info.field(text);
    key.field = [field](Case&, std::size_t) { return field; };  // its type, for messages
    good = store_value({*item, path, key}, field, context.findings) && good;
    for (std::size_t k = before; k < context.findings.problems.size(); ++k)
      context.findings.problems[k].topic = "field";
  }
  return good;
}

bool fail(const FieldContext& context, const std::string& path, const std::string& what, const std::string& detail)
{
  refuse_field(context, path, what, detail);
  return false;
}

/// Which independent fields it is the sum of.
bool set_parts(const FieldContext& context, RandomText& text)
{
  const std::string path = join_path(context.entry.path, "mix");
  const Node* mix = find_item(context.entry.node, "mix");
  if (mix == nullptr) {
    text.field.parts = {{static_cast<std::uint32_t>(text.number), 1.0}};
    return true;
  }
  text.field.parts.clear();
  Real squares = 0.0;
  KeyInfo pairs = key_like(context.entry.key, "-", any_number);
  pairs.field = [](Case&, std::size_t) { return OwnForm{"a list [[field, weight], ...]", {}, {}}; };
  std::vector<Vec<2>> parts;
  if (!read_places({*mix, path, pairs}, *mix, path, context.findings, parts)) return false;
  for (const Vec<2>& part : parts) {
    if (part[0] < 0.0 || part[0] > 1e6 || part[0] != std::floor(part[0]))
      return fail(context, path, fmt::format("{} is no number of a field", part[0]), "A whole number, from 0.");
    const auto number = static_cast<std::uint32_t>(part[0]);
    if (std::ranges::find(text.field.parts, number, [](const auto& other) { return other.first; }) !=
        text.field.parts.end())
      return fail(context, path, fmt::format("field {} stands twice in `mix`", number),
          "Its weights would add up, and the field have another variance than `cov` says. Give each once.");
    text.field.parts.emplace_back(number, part[1]);
    squares += part[1] * part[1];
  }
  if (std::abs(squares - 1.0) > 1e-9)
    return fail(context, path, "the squares of the weights of `mix` must add up to one",
        fmt::format("Got {}; else the field has another variance than `cov` says.", squares));
  return true;
}

/// Beyond that share of places where the value is not positive a normal field is refused.
constexpr Real widest_normal = 0.25;  // Phi(-1/0.25) = 3e-5

bool check_text(const FieldContext& context, const RandomText& text)
{
  if (const Vec<2>& theta = text.field.scale; theta[1] > theta[0])
    context.findings.warnings.push_back({join_path(context.entry.path, "theta"),
        "the soil varies more along x than along y",
        fmt::format("Got scales of {:g} m along x and {:g} m along y. Layers that were laid down vary over 0.5 to 2 m "
                    "along y, and\nover tens of metres along x. Swap the two.",
            theta[0], theta[1]),
        "field"});
  if (text.distribution == "normal" && text.cov > widest_normal)
    return fail(context, join_path(context.entry.path, "cov"), "a normal field so wide has negative values",
        fmt::format("Got a coefficient of variation of {}; allowed for a normal field: at most {}, where 3 of "
                    "100 000 values are below zero.\nA lognormal field has none.",
            text.cov, widest_normal));
  const double n = GaussianField::n_nodes(text.field);
  if (n > most_nodes)
    return fail(context, context.entry.path, "the random field has too many nodes",
        fmt::format("{:.2g}, eight along each theta, from x = y = 0 over all of the box; allowed: {:.2g}.\nGive "
                    "larger scales of fluctuation, or a smaller box nearer to x = y = 0.",
            n, most_nodes));
  return true;
}

/// [[x, y, value], ...] -> scores.
bool read_known(const Node& list, const FieldContext& context, const FieldValue& mean, RandomText& text)
{
  const std::string path = join_path(context.entry.path, list.name);
  if (list.kind != NodeKind::list || list.items.empty() || list.items.size() > most_known)
    return fail(context, path, "`known` must be a list of places with their values",
        fmt::format("Got {}; allowed: 1 to {} of [x, y, value].", describe_value(list), most_known));
  if (context.needs.outlines || context.needs.stress)
    return fail(context, path, "`known` needs a mean that follows from the place alone",
        "The mean follows from the ground above. Condition its parameters instead, as S or pop.");
  if (text.field.parts.size() > 1)
    return fail(
        context, path, "`known` and `mix` cannot be combined", "Leave out the correlation or the known values.");
  const KeyInfo place = key_like(context.entry.key, "m", any_number);
  const FieldMarginal marginal = text.distribution == "normal" ? FieldMarginal::normal : FieldMarginal::lognormal;
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const Node& item = list.items[k];
    const std::string at = fmt::format("{}[{}]", path, k);
    if (item.kind != NodeKind::list || item.items.size() != 3)
      return fail(context, at, "`known` must be a list of places with their values",
          fmt::format("Got {}; a place has three numbers, [x, y, value].", describe_value(item)));
    Vec<2> x{};
    Real value = 0.0;
    if (!store_value({item.items[0], at + "[0]", place}, &x[0], context.findings) ||
        !store_value({item.items[1], at + "[1]", place}, &x[1], context.findings) ||
        !store_value({item.items[2], at + "[2]", context.entry.key}, &value, context.findings))
      return false;
    for (std::size_t d = 0; d < 2; ++d)
      if (x[d] < text.field.low[d] || x[d] > text.field.high[d])
        return fail(context, at, "a known value lies outside of the box of the field",
            fmt::format("At ({:g}, {:g}) m; the box is from ({:g}, {:g}) to ({:g}, {:g}) m.", x[0], x[1],
                text.field.low[0], text.field.low[1], text.field.high[0], text.field.high[1]));
    const Real score = score_of(marginal, text.cov, value / mean({x}));
    if (!std::isfinite(score))
      return fail(context, at, "the distribution has no such value",
          fmt::format("Got {} {} where the mean is {:g}.", value, context.entry.key.unit, mean({x})));
    text.field.known.push_back({x, score});
  }
  return true;
}

}  // namespace

std::vector<std::string> random_distributions() { return {"lognormal", "normal"}; }

std::vector<std::string> random_correlations()
{
  std::vector<std::string> names;
  for (const CorrelationKind& kind : correlation_kinds()) names.emplace_back(kind.name);
  return names;
}

const CorrelationKind& correlation_named(std::string_view name)
{
  return *std::ranges::find(correlation_kinds(), name, &CorrelationKind::name);
}

std::optional<RandomField> read_random_field(const Node& table, const FieldContext& outer)
{
  const FieldContext context{
      {table, join_path(outer.entry.path, table.name), outer.entry.key}, outer.folder, outer.findings, outer.needs};
  if (table.kind != NodeKind::table)
    return refuse_field(outer, context.entry.path, "`random` must be a table",
        fmt::format("Got {}; keys of random: {}.", describe_value(table), plain_list(names_of_keys())));
  const Node* mean = find_item(table, "mean");
  if (mean == nullptr)
    return refuse_field(outer, context.entry.path, "`random` needs `mean`", "A number, or a field: the trend.");
  RandomText text;
  if (refuse_unknown_keys(table, names_of_keys(), context)) return std::nullopt;
  const bool good = read_keys(table, context, text);
  if (good) text.field.correlation = &correlation_named(text.correlation);
  const FieldContext inner{
      {*mean, join_path(context.entry.path, "mean"), outer.entry.key}, outer.folder, outer.findings, outer.needs};
  const auto trend = read_field(inner);
  if (!good || !trend || !set_parts(context, text) || !check_text(context, text)) return std::nullopt;
  text.field.seed = static_cast<std::uint32_t>(text.seed);
  text.field.realisation = static_cast<std::uint32_t>(text.realisation);
  const Node* known = find_item(table, "known");
  if (known != nullptr && !read_known(*known, context, *trend, text)) return std::nullopt;
  context.needs.scales.push_back({text.field.scale, text.field.correlation});
  const FieldMarginal marginal = text.distribution == "normal" ? FieldMarginal::normal : FieldMarginal::lognormal;
  return RandomField{std::move(text.field), marginal, text.cov, *trend};
}

std::optional<FieldValue> read_random(const Node& table, const FieldContext& context)
{
  const auto random = read_random_field(table, context);
  if (!random) return std::nullopt;
  try {
    return by_random(random->field, random->marginal, random->cov, random->mean);
  } catch (const RunError& error) {
    return refuse_field(context, context.entry.path + ".random.known", "the known values cannot be used", error.what());
  }
}

std::string describe_random_keys()
{
  std::string out = "  mean          a number or a field: the trend\n";
  for (const RandomKey& key : random_keys)
    out += fmt::format("  {:<14}{}{}\n", key.name,
        key.unit == "-" || key.unit.empty() ? "" : fmt::format("[{}] ", key.unit), key.meaning);
  out +=
      "  known         [[x, y, value], ...]: values from soundings, which every draw has there\n"
      "  mix           [[field, weight], ...] instead of field: the sum of several, squares of the weights adding "
      "up to one\n";
  out += "\nKinds of correlation, over the distance d; along x times along y\n";
  for (const CorrelationKind& kind : correlation_kinds()) out += fmt::format("  {:<14}{}\n", kind.name, kind.meaning);
  return out;
}

}  // namespace terp
