// A topic is tried from the narrow to the wide: a law, a scheme, fields, a file of a run. Then all keys of that path
// count, or else all that end in it, with the quantities of that name. Small letters are tried if nothing was found.

#include "io/case/explain.hpp"

#include "math/closest.hpp"
#include "run/measure/followers.hpp"
#include "io/case/case_file.hpp"
#include "io/case/field_kinds.hpp"
#include "io/case/key_text.hpp"
#include "io/case/keys.hpp"
#include "io/case/mesh_kinds.hpp"
#include "io/case/units.hpp"
#include "mpm/schemes/scheme.hpp"
#include "run/report/frame_fields.hpp"
#include "run/report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace terp {
namespace {

/// Parts of a path without entry numbers: "body[0].box" and "body[].box" -> body, box.
std::vector<std::string> named_parts(std::string_view path)
{
  auto parts = split_path(path);
  std::erase_if(parts, [](const std::string& part) { return part.starts_with('['); });
  return parts;
}

/// Whether "material.clay.eta" or "material.eta" means "material.NAME.eta".
bool means(const std::string& topic, const std::string& pattern)
{
  const auto is_any = [](const std::string& part) { return part == "NAME" || part == "SIDE"; };
  const auto same = [&](const std::string& a, const std::string& b) { return a == b || is_any(b); };
  const auto asked = named_parts(topic);
  auto known = named_parts(pattern);
  if (std::equal(asked.begin(), asked.end(), known.begin(), known.end(), same)) return true;
  std::erase_if(known, is_any);
  return asked == known;
}

/// Whether the path ends in the topic: "length" and "softening.length" of "material.NAME.softening.length".
bool is_end(const std::string& topic, const std::string& path)
{
  const auto asked = named_parts(topic), known = named_parts(path);
  return asked.size() <= known.size() && std::equal(asked.rbegin(), asked.rend(), known.rbegin());
}

std::string row(std::string_view label, const std::string& text)
{
  return text.empty() || text == "-" ? "" : fmt::format("    {:<10}{}\n", label, text);
}

/// Lines of at most 96 characters, each with the margin.
std::string wrapped(const std::string& text, const std::string& margin)
{
  constexpr std::size_t width = 96;
  std::string out, line;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!line.empty() && line.size() + 1 + word.size() > width) out += margin + line + '\n', line.clear();
    line += (line.empty() ? "" : " ") + word;
    begin = end + 1;
  }
  return out + margin + line + '\n';
}

/// The units that a key takes, where it is a number or holds some.
std::string units_text(const KeyInfo& key)
{
  const std::vector<std::string> units = units_of_key(key.unit);
  return units.empty() || key.unit == "-" ? "" : fmt::format("\"1 {}\", in {}", units[0], plain_list(units));
}

std::string describe_key(const KeyInfo& key, const std::string& name)
{
  std::string fallback = key.required ? "none: the key is required" : key.default_text;
  if (!key.required_for.empty()) fallback = "none: required for " + key.required_for;
  return "  " + name + '\n' + wrapped(key.meaning, "    ") + row("equation", key.equation) + row("unit", key.unit) +
         row("allowed", allowed_text(key)) + row("instead", key.instead) + row("as text", units_text(key)) +
         row("default", fallback) + row("in stages", key.in_stage ? "may change" : "");
}

std::string indented_lines(std::string_view text, std::string_view margin)
{
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += fmt::format("{}{}\n", margin, text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string describe_law(const MaterialType& law)
{
  std::string out = fmt::format("{}: material model\n  {}\n", law.name, law.summary);
  if (!law.equations.empty()) out += "\nEquations\n" + indented_lines(law.equations, "  ");
  out += fmt::format("\nKeys of [material.NAME] with model = \"{}\"\n", law.name);
  out += describe_key(*find_key("material.NAME.density"), "density");
  for (const KeyInfo& key : keys_of_law(law)) out += describe_key(key, last_part(key.path));
  if (!law.state.empty()) out += "\nState of a material point, also an output field\n";
  for (const StateInfo& state : law.state)
    out += fmt::format("  {}\n    {}\n", state.name, state.meaning) + row("unit", std::string(state.unit)) +
           row("averaged",
               state.averaging == Averaging::cell ? "over the cell in mpm_mixed" : "over the sub-cell in mpm_mixed");
  if (!law.derived.empty()) out += "\nOutput fields that follow from it\n";
  for (const DerivedInfo& derived : law.derived)
    out += fmt::format("  {}\n    {}\n", derived.name, derived.meaning) + row("unit", std::string(derived.unit));
  return out;
}

std::string describe_scheme(const Scheme& scheme)
{
  std::string out = fmt::format(
      "{0}: scheme\n  {1}\n  Choose it with scheme = \"{0}\" at the top of the case file; its equations are in "
      "docs/methods.md.\n",
      scheme.name, scheme.summary);
  if (looks_at(scheme, "as"))
    out += "  In the form of the paper: as = \"paper\" in [method] (terp explain method.as).\n";
  if (!scheme.with_overlap.empty())
    out += wrapped(fmt::format("With shares that overlap, the default of soil, it is another method than the paper's: "
                               "{} (decision 0042).",
                       scheme.with_overlap),
        "  ");
  return out;
}

std::string describe_section(const SectionInfo& section)
{
  const std::string need = section.required ? "required" : "may be left out";
  std::string out =
      fmt::format("{}: section of the case file, {}\n  {}\n\nKeys\n", header_of(section.path), need, section.meaning);
  for (const KeyInfo& key : all_keys()) {
    const std::string parent = parent_path(key.path);
    const bool of_side = section.path == "boundary" && parent == "boundary.SIDE";
    if (parent == section.path || of_side)
      out += describe_key(key, of_side ? "SIDE." + last_part(key.path) : key.path.substr(parent.size() + 1));
  }
  for (const SectionInfo& below : all_sections())
    if (parent_path(below.path) == section.path)
      out += fmt::format("  {}\n    {}\n", header_of(below.path), below.meaning);
  if (section.path == "mesh") out += "\nKeys that belong together\n" + mesh_kinds_text("  ") + '\n';
  if (section.path == "material.NAME")
    out += fmt::format("  and those of the model: terp explain MODEL, one of {}\n", plain_list(material_model_names()));
  return out;
}

std::string describe_quantity(const QuantityInfo& quantity)
{
  return fmt::format("  {}\n", quantity.name) + wrapped(std::string(quantity.meaning), "    ") +
         row("unit", std::string(quantity.unit));
}

struct QuantityFile {
  std::string name;
  std::string_view meaning;
  std::vector<QuantityInfo> quantities;
};

std::vector<QuantityFile> files_of_quantities()
{
  std::vector<QuantityFile> files;
  for (const auto& table : all_tables()) files.push_back({table->file(), table->meaning, table->columns});
  QuantityFile& summary = files.emplace_back(QuantityFile{"summary.json", "the numbers that remain of a run", {}});
  for (const SummaryQuantity& quantity : summary_quantities()) summary.quantities.push_back(quantity.info);
  for (const FollowerType* type : all_followers())
    summary.quantities.insert(summary.quantities.end(), type->summary.begin(), type->summary.end());
  return files;
}

std::string describe_file(const QuantityFile& file)
{
  std::string out = fmt::format("{}: file of a run\n  {}\n\nQuantities\n", file.name, file.meaning);
  for (const QuantityInfo& quantity : file.quantities) out += describe_quantity(quantity);
  return out;
}

using Match = bool (*)(const std::string& topic, const std::string& path);

std::vector<std::string> find_blocks(const std::string& topic, Match match)
{
  std::vector<std::string> blocks;
  for (const SectionInfo& section : all_sections())
    if (match(topic, section.path)) blocks.push_back(describe_section(section));
  for (const KeyInfo& key : all_keys())
    if (match(topic, key.path) && key.path != "boundary.SIDE")  // shown with its section
      blocks.push_back("key of the case file\n" + describe_key(key, topic_of(key.path)));
  for (const MaterialType* law : all_materials())
    for (const KeyInfo& key : keys_of_law(*law))
      if (match(topic, key.path))
        blocks.push_back(
            fmt::format("key of material model `{}`\n", law->name) + describe_key(key, topic_of(key.path)));
  return blocks;
}

bool is_kind_of_field(const std::string& topic)
{
  return std::ranges::find(field_kinds(), topic, &FieldKind::name) != field_kinds().end();
}

std::vector<std::string> all_topics()
{
  std::vector<std::string> topics = material_model_names();
  topics.emplace_back("field");
  for (const Scheme* scheme : all_schemes()) topics.emplace_back(scheme->name);
  const auto add = [&](const std::string& path) {
    topics.push_back(topic_of(path)), topics.push_back(last_part(path));
  };
  for (const QuantityFile& file : files_of_quantities()) {
    topics.push_back(file.name);
    for (const QuantityInfo& quantity : file.quantities) topics.emplace_back(quantity.name);
  }
  for (const FrameField& field : all_frame_fields()) topics.push_back(field.name);
  for (const SectionInfo& section : all_sections()) add(section.path);
  for (const KeyInfo& key : all_keys()) add(key.path);
  for (const MaterialType* law : all_materials())
    for (const KeyInfo& key : keys_of_law(*law)) add(key.path);
  return topics;
}

[[noreturn]] void refuse_topic(const std::string& topic)
{
  const std::string nearest = closest(topic, all_topics());
  std::vector<std::string> schemes, sections, files;
  for (const Scheme* scheme : all_schemes()) schemes.emplace_back(scheme->name);
  for (const SectionInfo& section : all_sections()) sections.push_back(topic_of(section.path));
  for (const QuantityFile& file : files_of_quantities()) files.push_back(file.name);
  throw CaseError(
      fmt::format("error: there is nothing to explain about `{}`\n\n{}"
                  "  Material models: {}\n  Schemes: {}\n  Sections: {}\n  Files of a run: {}\n"
                  "  Keys: dotted or by their last part, as in mesh.cell or courant\n",
          topic, nearest.empty() ? "" : fmt::format("  Did you mean `{}`?\n", nearest),
          plain_list(material_model_names()), plain_list(schemes), plain_list(sections), plain_list(files)));
}

template <class Infos>
std::string list_of(const char* title, const Infos& infos)
{
  std::string out = fmt::format("{}\n", title);
  std::size_t width = 18;
  for (const auto& [name, text] : infos) width = std::max(width, name.size());
  for (const auto& [name, text] : infos) out += fmt::format("  {:<{}}{}\n", name, width + 2, text);
  return out;
}

std::string find_explanation(const std::string& topic)
{
  if (const MaterialType* law = find_material(topic)) return describe_law(*law);
  if (const Scheme* scheme = find_scheme(topic)) return describe_scheme(*scheme);
  if (topic == "field" || is_kind_of_field(topic)) return describe_field_kinds();
  const std::vector<QuantityFile> files = files_of_quantities();
  for (const QuantityFile& file : files)
    if (file.name == topic) return describe_file(file);
  auto blocks = find_blocks(topic, means);
  if (blocks.empty()) blocks = find_blocks(topic, is_end);
  for (const QuantityFile& file : files)
    for (const QuantityInfo& quantity : file.quantities)
      if (quantity.name == topic) blocks.push_back(fmt::format("in {}\n", file.name) + describe_quantity(quantity));
  for (const FrameField& field : all_frame_fields())
    if (field.name == topic)
      blocks.push_back("in the frames\n" + describe_quantity({field.name, field.unit, field.label, field.meaning}));
  if (blocks.empty() && is_key_of_shansep(topic)) return describe_field_kinds();
  std::string out;
  for (const std::string& block : blocks) out += (out.empty() ? "" : "\n") + block;
  return out;
}

}  // namespace

std::string explain(const std::string& topic)
{
  if (const std::string found = find_explanation(topic); !found.empty()) return found;
  std::string small = topic;  // SHANSEP, POP
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  if (const std::string found = find_explanation(small); !found.empty()) return found;
  refuse_topic(topic);
}

std::string list()
{
  using Rows = std::vector<std::pair<std::string, std::string>>;
  Rows materials, schemes, fields = {{"position, id", "[m, -] always written"}};
  for (const MaterialType* law : all_materials()) materials.emplace_back(law->name, law->summary);
  for (const Scheme* scheme : all_schemes()) schemes.emplace_back(scheme->name, scheme->summary);
  for (const FrameField& field : all_frame_fields())
    fields.emplace_back(field.name, fmt::format("[{}] {}", field.unit, field.meaning));
  return list_of("Materials", materials) + '\n' + list_of("Schemes", schemes) + '\n' +
         list_of("Output fields", fields) + "\nMore: terp explain NAME, for a material, scheme, section or key\n";
}

}  // namespace terp
