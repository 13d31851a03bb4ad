// The tree of the file is walked. A value of a soil is scaled in a copy, which becomes one change as a whole; so does
// `set` of a stage, whose keys may be quoted: "material.clay.su_peak.shansep.S". So a value is found by the parameter
// and by what of its key stands behind that.

#include "cli/strength_levers.hpp"

#include "io/case/field_kinds.hpp"
#include "io/case/units.hpp"
#include "soil/laws/material.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace terp {
namespace {

using PathParts = std::vector<std::string>;

/// Of one lever and factor.
class Scaling {
 public:
  Scaling(const StrengthLever& lever, Real factor, ScaledStrength& found)
      : lever_(lever), factor_(factor), found_(found)
  {
  }

  /// parts: of the key so far. True: something in the node was scaled.
  bool visit(Node& node, const PathParts& parts)
  {
    if (const auto behind = place_behind_parameter(parts)) return scale_parameter(node, parts, *behind);
    bool any = false;
    if (node.kind == NodeKind::table)
      for (Node& item : node.items) any = visit(item, joined(parts, item.name)) || any;
    return any;
  }

  /// Changes of a table of soils or sides, one for each value.
  void change_values(const Node& node, const PathParts& parts, const std::string& path)
  {
    if (node.kind != NodeKind::table) return;
    for (const Node& item : node.items) {
      const PathParts key = joined(parts, item.name);
      const std::string at = join_path(path, item.name);
      if (!place_behind_parameter(key)) {
        change_values(item, key, at);
        continue;
      }
      Node copy = item;
      if (visit(copy, key)) found_.changes.push_back(at + '=' + toml_value(copy));
    }
  }

 private:
  const StrengthLever& lever_;
  const Real factor_;
  ScaledStrength& found_;

  static PathParts joined(PathParts parts, const std::string& name)
  {
    for (std::string& part : split_path(name)) parts.push_back(std::move(part));
    return parts;
  }

  /// Number of the part behind the parameter, material.NAME[.below].KEY, or behind the key of a side.
  static std::optional<std::size_t> place_behind_parameter(const PathParts& parts)
  {
    std::size_t key = 2;
    if (parts.size() > 2 && parts[0] == "material" && (parts[2] == "below" || parts[2] == "above")) key = 3;
    const bool is_one = !parts.empty() && (parts[0] == "material" || parts[0] == "boundary") && parts.size() > key;
    return is_one ? std::optional(key + 1) : std::nullopt;
  }

  bool scale_parameter(Node& node, const PathParts& parts, std::size_t behind)
  {
    const std::string& key = parts[behind - 1];
    if (std::ranges::find(lever_.keys, key) == lever_.keys.end()) return false;
    const PathParts tail(parts.begin() + static_cast<std::ptrdiff_t>(behind), parts.end());
    if (!lever_.within.empty()) return scale_within(node, tail, fmt::format("{}", fmt::join(parts, ".")));
    if (tail.empty()) return scale_value(node, fmt::format("{}", fmt::join(parts, ".")));
    Node table;  // of which the key names one item: su_peak.depth
    table.items.push_back(node);
    table.items[0].name = tail[0];
    if (tail.size() > 1 || !scale_value(table, fmt::format("{}", fmt::join(parts, ".")))) return false;
    node.items = table.items[0].items;
    return true;
  }

  /// The item `within` of SHANSEP, or of a yield stress.
  bool scale_within(Node& node, const PathParts& tail, const std::string& path)
  {
    if (!tail.empty() && tail.back() == lever_.within) return scale_value(node, path);
    if (node.kind != NodeKind::table) return false;
    bool any = false;
    for (Node& item : node.items)
      if (item.name == lever_.within)
        any = scale_value(item, join_path(path, item.name)) || any;
      else if (item.name == "shansep")
        any = scale_within(item, {}, join_path(path, item.name)) || any;
    return any;
  }

  /// A number, with a unit or without, a formula, or a field.
  bool scale_value(Node& node, const std::string& path)
  {
    if (node.kind == NodeKind::number || node.kind == NodeKind::integer) return scale_number(node);
    if (node.kind == NodeKind::text) return scale_text(node);
    if (node.kind != NodeKind::table) return false;
    for (Node& item : node.items) {
      if (item.name == "depth" || item.name == "elevation" || item.name == "table") return scale_line(item);
      if (item.name == "random") return scale_random(item, path);
      if (item.name == "csv") return leave(path, "a table in a file");
    }
    return false;  // SHANSEP: levers of their own
  }

  bool scale_number(Node& node) const
  {
    const Real value = node.kind == NodeKind::integer ? static_cast<Real>(node.integer) : node.number,
               scaled = std::clamp(value * factor_, lever_.least, lever_.greatest);
    node.kind = NodeKind::number, node.number = scaled;
    return scaled != value;
  }

  bool scale_text(Node& node) const
  {
    const auto quantity = is_formula(node) ? std::nullopt : parse_quantity(node.text);
    if (quantity) {
      const Real value = std::stod(quantity->number);
      node.text = fmt::format("{:.6g} {}", factor_ * value, quantity->name);
      return value != 0.0;
    }
    node.text = fmt::format("{:g}*({})", factor_, node.text);
    return true;
  }

  /// [[argument, value], ...]
  bool scale_line(Node& list)
  {
    bool any = false;
    for (Node& pair : list.items)
      if (pair.kind == NodeKind::list && pair.items.size() == 2) any = scale_value(pair.items[1], "") || any;
    return any;
  }

  bool scale_random(Node& table, const std::string& path)
  {
    if (find_item(table, "known") != nullptr) return leave(path, "a random field through known values");
    Node* mean = find_item(table, "mean");
    return mean != nullptr && scale_value(*mean, path);
  }

  bool leave(const std::string& path, const char* why)
  {
    std::string text = fmt::format("{} ({})", path, why);
    if (std::ranges::find(found_.left, text) == found_.left.end()) found_.left.push_back(std::move(text));
    return false;
  }
};

const std::vector<std::string_view> undrained{
    "su_peak", "su_residual", "su_remoulded", "su_active", "su_direct", "su_passive"};
const std::vector<std::string_view> undrained_or_yield{
    "su_peak", "su_residual", "su_remoulded", "su_active", "su_direct", "su_passive", "yield_stress"};

}  // namespace

/// Factors: how well a soil investigation usually knows the input (docs/convergence.md).
const std::vector<StrengthLever>& strength_levers()
{
  static const std::vector<StrengthLever> levers = {
      {"S", undrained, "S", 0.85, 1.15},
      {"POP", undrained_or_yield, "pop", 0.7, 1.3},
      {"OCR", undrained_or_yield, "ocr", 0.8, 1.25, 1.0},
      {"yield stress in SHANSEP", undrained, "yield_stress", 0.8, 1.25},
      {"m", undrained, "m", 0.9, 1.1, 0.0, 1.0},
      {"least S_u", undrained, "minimum", 0.85, 1.15},
      {"yield stress", {"yield_stress"}, "", 0.8, 1.25},
      {"S_u", undrained, "", 0.85, 1.15},
      {"sensitivity", {"sensitivity"}, "", 0.8, 1.25, 1.0},
      {"residual share", {"residual_share"}, "", 0.8, 1.25},
      {"ratios of S_u", {"direct_ratio", "passive_ratio"}, "", 0.85, 1.15},
      {"cohesion", {"cohesion", "cohesion_residual"}, "", 0.8, 1.25},
      {"phi", {"friction_angle", "friction_angle_residual", "dilatancy_angle", "dilatancy_angle_residual"}, "", 0.9,
          1.1},
      {"tension", {"tension_cutoff"}, "", 0.8, 1.25},
      {"strength of sides", {"adhesion", "friction"}, "", 0.8, 1.25},
  };
  return levers;
}

ScaledStrength scale_strength(const Node& root, const StrengthLever& lever, Real factor)
{
  ScaledStrength found;
  Scaling scaling(lever, factor, found);
  for (const char* list : {"material", "boundary"})
    if (const Node* table = find_item(root, list)) scaling.change_values(*table, {list}, list);
  const Node* stages = find_item(root, "stage");
  for (std::size_t k = 0; stages != nullptr && k < stages->items.size(); ++k)
    if (const Node* set = find_item(stages->items[k], "set")) {
      Node copy = *set;
      if (scaling.visit(copy, {})) found.changes.push_back(fmt::format("stage[{}].set={}", k, toml_value(copy)));
    }
  return found;
}

std::vector<std::string> strengths_without_lever(const Node& root)
{
  std::vector<std::string> keys;
  const auto has_lever = [](std::string_view name) {
    return std::ranges::any_of(strength_levers(),
        [&](const StrengthLever& lever) { return std::ranges::find(lever.keys, name) != lever.keys.end(); });
  };
  const auto look = [&](const Node& soil, const std::string& path) {
    const Node* model = find_item(soil, "model");
    if (model == nullptr || model->kind != NodeKind::text) return;
    if (model->text == "library") keys.push_back(path + " (the law of a library)");
    if (const MaterialType* law = find_material(model->text))
      for (const ParameterInfo& p : law->parameters)
        if (is_strength(p.reduction) && !has_lever(p.name) && find_item(soil, p.name) != nullptr)
          keys.push_back(join_path(path, p.name));
  };
  const Node* soils = find_item(root, "material");
  if (soils == nullptr || soils->kind != NodeKind::table) return keys;
  for (const Node& soil : soils->items) {
    const std::string path = join_path("material", soil.name);
    look(soil, path);
    for (const char* part : {"below", "above"})
      if (const Node* inner = find_item(soil, part)) look(*inner, join_path(path, part));
  }
  return keys;
}

}  // namespace terp
