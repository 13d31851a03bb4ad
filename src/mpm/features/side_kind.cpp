// The tables of kinds and of their numbers, and the functions that the entries name. A new kind is a word of SideKind,
// an entry here, and functions of its own where those that exist do not do; a number that it takes is a member of
// SideCondition and an entry here. What it does across and along a side is one of those in SideAction; another
// mechanism is a value of Across or Along, and acts in conditions.cpp.
#include "mpm/features/side_kind.hpp"

#include "math/errors.hpp"
#include "mpm/features/side_table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

/// Adhesion, and Coulomb friction under the push.
Real adhesion_and_friction(const NodeSide& side, Real push)
{
  return side.adhesion_force + side.friction * std::max(push, 0.0);
}

std::string resistance_text(const SideCondition& side)
{
  std::string text;
  if (side.adhesion > 0.0) text += fmt::format(", adhesion {:.4g} kPa", side.adhesion / 1e3);
  if (side.friction > 0.0) text += fmt::format(", friction {:.4g}", side.friction);
  return text.empty() ? ", smooth" : text;
}

std::string velocity_text(const SideCondition& side)
{
  return (side.velocity_at ? std::string(" by a formula")
                           : fmt::format(" [{:.4g}, {:.4g}] m/s", side.velocity[0], side.velocity[1])) +
         (side.slip ? ", smooth" : "");
}

/// Friction that feels only half of what the plane carries (decision 0015).
std::optional<SideKindInfo::Doubt> doubt_friction(const SideCondition& side)
{
  if (!(side.friction > 0.0)) return {};
  return SideKindInfo::Doubt{"friction", "a bilateral contact meets only pushes with friction and forgets pulls",
      "Friction wants contact = \"separating\" (docs/decisions/0015-contact-at-the-base.md)."};
}

const SideNumber numbers[] = {
    {.name = "adhesion",
        .unit = "Pa",
        .range = not_negative,
        .usual = between(10.0, 1e7),
        .meaning = "adhesion a of the contact plane",
        .at = &SideCondition::adhesion},
    {.name = "friction",
        .unit = "-",
        .range = not_negative,
        .usual = between(0.0, 2.0),
        .meaning = "tangent mu of the friction angle of the contact plane, not the angle itself",
        .at = &SideCondition::friction},
};

constexpr const char *red = "#b3261e", *purple = "#6a1b9a", *green = "#1b7f3b", *grey = "#8a94a0";

const SideKindInfo table[] = {
    {.kind = SideKind::free,
        .key = "",
        .word = "free",
        .meaning = "no condition",
        .report = SideReport::arrival_and_rise,
        .label = "free",
        .legend = "free boundary of the mesh",
        .colour = grey},
    {.kind = SideKind::open,
        .key = "",
        .word = "open",
        .meaning = "soil that reaches the side leaves the model and is entered in left_the_mesh.csv",
        .soil_leaves = true,
        .report = SideReport::none,
        .label = "open, soil leaves there",
        .legend = "open side",
        .colour = green},
    {.kind = SideKind::roller,
        .key = "",
        .word = "roller",
        .meaning = "no motion across, free along it",
        .action = {.across = Across::prescribed},
        .report = SideReport::arrival_and_rise,
        .label = "roller, no motion across",
        .legend = "constrained side",
        .colour = red,
        .marks = SideMarks::circles},
    {.kind = SideKind::fixed,
        .key = "",
        .word = "fixed",
        .meaning = "no motion",
        .action = {.across = Across::prescribed, .along = Along::prescribed},
        .report = SideReport::arrival_and_rise,
        .label = "fixed",
        .legend = "constrained side",
        .colour = red,
        .marks = SideMarks::ticks},
    {.kind = SideKind::contact_bilateral,
        .key = "contact",
        .word = "bilateral",
        .meaning = "never opens",
        .takes = {"adhesion", "friction"},
        .action = {.across = Across::prescribed, .along = Along::resisted, .strength = adhesion_and_friction},
        .label = "contact that never opens",
        .numbers = resistance_text,
        .legend = "constrained side",
        .colour = red,
        .marks = SideMarks::ticks,
        .doubt = doubt_friction},
    {.kind = SideKind::contact_separating,
        .key = "contact",
        .word = "separating",
        .meaning = "opens under tension",
        .takes = {"adhesion", "friction"},
        .action = {.across = Across::opens, .along = Along::resisted, .strength = adhesion_and_friction},
        .label = "contact that may open",
        .numbers = resistance_text,
        .legend = "constrained side",
        .colour = red,
        .marks = SideMarks::ticks},
    {.kind = SideKind::velocity,
        .key = "velocity",
        .word = "",
        .meaning = "",
        .takes = {"slip"},
        .action = {.across = Across::prescribed, .along = Along::prescribed},
        .label = "velocity",
        .numbers = velocity_text,
        .legend = "prescribed velocity",
        .colour = purple,
        .marks = SideMarks::ticks},
};

}  // namespace

bool is_driven(const SideCondition& side) { return side.velocity_at || side.velocity != Vec<2>{0.0, 0.0}; }

std::span<const SideKindInfo> side_kinds() { return table; }

const SideKindInfo& info_of(SideKind kind)
{
  const SideKindInfo& info = table[static_cast<std::size_t>(kind)];
  TERP_ASSERT(info.kind == kind);
  return info;
}

std::vector<const SideKindInfo*> kinds_named_by(std::string_view key)
{
  std::vector<const SideKindInfo*> kinds;
  for (const SideKindInfo& info : table)
    if (info.key == key) kinds.push_back(&info);
  return kinds;
}

std::vector<std::string_view> keys_of_kinds()
{
  std::vector<std::string_view> keys;
  for (const SideKindInfo& info : table)
    if (!info.key.empty() && std::ranges::find(keys, info.key) == keys.end()) keys.push_back(info.key);
  return keys;
}

std::span<const SideNumber> side_numbers() { return numbers; }

NodeSide node_side(const SideCondition& given, Vec<2> normal, Real half_length, Vec<2> x)
{
  SideAction action = info_of(given.kind).action;
  if (given.slip) action.along = Along::free;
  const Real length = std::hypot(normal[0], normal[1]);
  return {.action = action,
      .normal = {normal[0] / length, normal[1] / length},
      .half_length = half_length,
      .adhesion_force = given.adhesion * half_length,
      .friction = given.friction,
      .velocity = given.velocity_at ? given.velocity_at(x) : given.velocity};
}

NodeSide joined(const NodeSide& a, const NodeSide& b)
{
  const Real length = a.half_length + b.half_length, part = a.half_length / length;
  const Vec<2> sum{part * a.normal[0] + (1.0 - part) * b.normal[0], part * a.normal[1] + (1.0 - part) * b.normal[1]};
  const Real norm = std::hypot(sum[0], sum[1]);
  return {.action = a.action,
      .normal = {sum[0] / norm, sum[1] / norm},
      .half_length = length,
      .adhesion_force = a.adhesion_force + b.adhesion_force,
      .friction = part * a.friction + (1.0 - part) * b.friction,
      .velocity = a.velocity};
}

std::string describe(const SideCondition& side)
{
  const SideKindInfo& info = info_of(side.kind);
  return std::string(info.label) + (info.numbers == nullptr ? "" : info.numbers(side));
}

}  // namespace terp
