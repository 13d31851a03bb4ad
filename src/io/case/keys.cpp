// What is asked of the keys: sections, keys of a law, names of fields. The table itself is in key_table.cpp.

#include "io/case/keys.hpp"

#include "io/case/document.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/library_keys.hpp"
#include "run/report/frame_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {

const std::vector<KeyInfo>& all_keys()
{
  static const std::vector<KeyInfo> keys = [] {
    std::vector<KeyInfo> list = key_table();
    for (KeyInfo& key : list)
      if (key.default_text.empty()) key.default_text = default_text(key);
    return list;
  }();
  return keys;
}

const std::vector<SectionInfo>& all_sections()
{
  static const std::vector<SectionInfo> sections = {
      {"time", "how long to solve, in which steps", true},
      {"stage[]",
          "a part of the run with values of its own for some keys: loads, gravity, strengths (docs/stages.md); as many "
          "as needed, one after the other"},
      {"mesh", "the background mesh; its kind follows from the keys that are given", true},
      {"mesh.sides", "four lines between which a grid is spanned; they meet at the corners"},
      {"mesh.refine[]", "a place with smaller cells in a mesh from a polygon; as many as needed"},
      {"body[]", "one piece of soil, filled with material points; as many as needed", true},
      {"material.NAME", "a material with the name that bodies use", true},
      {"material.NAME.below",
          "what the soil is below the phreatic line at t = 0: model, its parameters and any other key of the material, "
          "in place of those beside it; needs [material.NAME.above] too"},
      {"material.NAME.above", "the same above the phreatic line"},
      {"material.NAME.softening",
          "softening over a distance instead of in each point, so that a slip surface takes the same energy on any "
          "mesh; of laws that soften (docs/softening_length.md)"},
      {"forces", "gravity and damping"},
      {"forces.damping", "damping of the nodal motion"},
      {"initial", "the stress before t = 0"},
      {"water", "pore pressure in the soil, and the load of free water on it (docs/water.md)"},
      {"water.situation[]",
          "water at another time, or under a name; keys that are left out are those of [water]; as many as needed"},
      {"flood",
          "the water that the ground shall hold back: whether it stands, is damaged or floods (docs/flood.md). Water "
          "that would flow over is not simulated"},
      {"flood.smallest_profile", "a profile that is looked for inside the ground that remains"},
      {"boundary", "the sides of the mesh; a side that is not named is free"},
      {"footing[]",
          "a rigid block that is pushed into the soil, its reaction measured (footings.csv); as many as needed, at "
          "most 8"},
      {"load[]",
          "a pressure on a stretch of the surface, always there or for a time (docs/loads.md); as many as needed"},
      {"method", "numerical choices; the defaults suit soil that fails (docs/methods.md)"},
      {"output", "what is written, and when"},
      {"output.fields", "fields of all material points in the frames"},
      {"output.history", "named points over time: history.csv"},
      {"output.ledger", "balances over time: ledger.csv"},
      {"output.checkpoint", "files to resume from"},
      {"reference", "results of other methods, which pictures show beside those of the run; no number depends on them"},
  };
  return sections;
}

namespace {

/// Takes the place of a field of the same parameter.
void set_field(MaterialCase& material, ParameterField field)
{
  const auto at = std::ranges::lower_bound(material.fields, field.parameter, {}, &ParameterField::parameter);
  if (at != material.fields.end() && at->parameter == field.parameter)
    *at = std::move(field);
  else
    material.fields.insert(at, std::move(field));
}

Field parameter_field(Case& c, std::size_t material, std::size_t k, Real typical)
{
  MaterialCase& m = c.materials[material];
  const auto found = std::ranges::find(m.fields, k, &ParameterField::parameter);
  return VaryingNumber{&m.parameters[k],
      [&m, k, typical](ParameterField field) {
        field.parameter = k;
        m.parameters[k] = typical;
        set_field(m, std::move(field));
      },
      found == m.fields.end() ? nullptr : &*found, &c.folder};
}

Field ratio_field(Case& c, std::size_t material, std::size_t k)
{
  RatioCase& ratio = c.materials[material].ratios[k];
  return VaryingNumber{&ratio.value, [&ratio](ParameterField field) { ratio.field = std::move(field); },
      ratio.field ? &*ratio.field : nullptr, &c.folder};
}

KeyInfo key_of(const ParameterInfo& parameter, std::size_t k)
{
  KeyInfo key{.path = "material.NAME." + std::string(parameter.name),
      .field = [k](Case& c, std::size_t i) { return &c.materials[i].parameters[k]; },
      .unit = std::string(parameter.unit),
      .range = parameter.range,
      .usual = parameter.usual,
      .required = !parameter.fallback && parameter.fallback_of.empty(),
      .instead = std::string(parameter.ratio.name),
      .may_be_infinite = parameter.fallback && std::isinf(*parameter.fallback),
      .in_stage = true,
      .meaning = std::string(parameter.meaning)};
  if (parameter.may_vary)
    key.field = [k, typical = parameter.typical](Case& c, std::size_t i) { return parameter_field(c, i, k, typical); };
  if (parameter.fallback) key.default_text = number_text(*parameter.fallback, key.unit);
  if (!parameter.fallback_of.empty()) key.default_text = fmt::format("the value of `{}`", parameter.fallback_of);
  return key;
}

KeyInfo key_of(const RatioInfo& ratio, std::size_t k)
{
  return {.path = "material.NAME." + std::string(ratio.name),
      .field = [k](Case& c, std::size_t i) { return ratio_field(c, i, k); },
      .range = ratio.range,
      .usual = ratio.usual,
      .meaning = std::string(ratio.meaning),
      .default_text = "not given"};
}

}  // namespace

std::vector<KeyInfo> keys_of_law(const MaterialType& law)
{
  std::vector<KeyInfo> keys;
  if (law.by_library) {
    keys = library_keys();
    for (KeyInfo& key : keys)
      if (key.default_text.empty()) key.default_text = default_text(key);
  }
  for (std::size_t k = 0; k < law.parameters.size(); ++k) keys.push_back(key_of(law.parameters[k], k));
  for (std::size_t k = 0; k < law.parameters.size(); ++k)
    if (const RatioInfo& ratio = law.parameters[k].ratio; !ratio.name.empty()) keys.push_back(key_of(ratio, k));
  return keys;
}

std::vector<std::string> output_field_names()
{
  std::vector<std::string> names;
  for (const FrameField& field : all_frame_fields()) names.push_back(field.name);
  return names;
}

std::vector<std::string> material_model_names()
{
  std::vector<std::string> names;
  for (const MaterialType* law : all_materials()) names.emplace_back(law->name);
  return names;
}

const std::vector<std::string>& side_names()
{
  static const std::vector<std::string> names = {"left", "right", "bottom", "top"};
  return names;
}

std::string unit_at(std::string_view path)
{
  const auto names_of = [](std::string_view text) {
    auto parts = split_path(text);
    std::erase_if(parts, [](const std::string& part) { return part.starts_with('['); });
    if (parts.size() > 3 && parts[0] == "material" && (parts[2] == "below" || parts[2] == "above"))
      parts.erase(parts.begin() + 2);  // the keys of a part are those of a material
    return parts;
  };
  const auto asked = names_of(path);
  std::string unit;
  std::size_t longest = 0;
  const auto look_at = [&](const KeyInfo& key) {
    const auto known = names_of(key.path);
    const auto same = [](const std::string& a, const std::string& b) { return a == "NAME" || a == "SIDE" || a == b; };
    if (known.size() <= longest || known.size() > asked.size()) return;
    if (std::equal(known.begin(), known.end(), asked.begin(), same)) unit = key.unit, longest = known.size();
  };
  for (const KeyInfo& key : all_keys()) look_at(key);
  for (const MaterialType* law : all_materials())
    for (const KeyInfo& key : keys_of_law(*law)) look_at(key);
  return unit;
}

std::string material_path(const MaterialCase& material)
{
  const std::string path = join_path("material", material.called());
  return material.zone == Zone::all ? path : path + (material.zone == Zone::below ? ".below" : ".above");
}

const KeyInfo* find_key(std::string_view path)
{
  for (const KeyInfo& key : all_keys())
    if (key.path == path) return &key;
  return nullptr;
}

const SectionInfo* find_section(std::string_view path)
{
  for (const SectionInfo& section : all_sections())
    if (section.path == path) return &section;
  return nullptr;
}

std::vector<std::string> names_in_section(std::string_view section)
{
  std::vector<std::string> names;
  const auto add = [&](std::string_view path) {
    if (parent_path(path) == section) names.push_back(last_part(path));
  };
  for (const KeyInfo& key : all_keys()) add(key.path);
  for (const SectionInfo& below : all_sections()) add(below.path);
  return names;
}

}  // namespace terp
