// A section has its path in the file, for messages, and its pattern in the table: "body[]" for "body[0]". Soil with
// `below` and `above` is read twice, from copies in which one part stands among the common keys. Problems of the second
// reading that the first had too are taken out. A key that is missing is not reported if an unknown one was probably
// meant for it.

#include "io/case/reader.hpp"
#include "model/water/level_series.hpp"

#include "math/closest.hpp"
#include "io/case/check_case.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/library_keys.hpp"
#include "io/case/mesh_kinds.hpp"
#include "io/case/side_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace terp {
namespace {

struct Section {
  const Node& table;
  std::string path;     ///< in this file: "body[0]", "material.clay"; "" for the file itself
  std::string pattern;  ///< in the table of keys: "body[]", "material.NAME"
  std::size_t number;   ///< of the body, refinement, material or side in the case
  std::vector<KeyInfo> law_keys = {};
  std::string law = "";
  const Node* part = nullptr;  ///< a table inside it whose keys stand with the others here: `below` of a material
  std::string part_path = "";

  std::string path_of(const Node& item) const
  {
    const bool in_part = part != nullptr && find_item(*part, item.name) != nullptr;
    return join_path(in_part ? part_path : path, item.name);
  }
};

class CaseReader {
 public:
  CaseReader(const Node& root, Case& values, Findings& findings) : root_(root), values_(values), findings_(findings) {}
  void read_section(const Section& section);

 private:
  void read_below(const Node& node, const std::string& path, const SectionInfo& info, std::size_t number);
  void read_list(const Node& list, const std::string& path, const SectionInfo& info);
  void read_materials(const Node& table);
  void read_material(const Node& table, const std::string& path);
  void read_parts(const Node& table, const std::string& path);
  void read_part(const Node& table, Zone zone, const std::string& path);
  void read_law(const Node& table, Section section, MaterialCase& material);
  void read_sides(const Node& table);
  void read_side(const Node& node, const std::string& path);
  void report_unknown(const Section& section, const Node& item, std::vector<std::string>& meant);
  void report_missing(const Section& section, const std::vector<std::string>& meant);
  bool is_table(const Node& node, const std::string& path, const std::string& header);
  void report(Problem problem) { findings_.problems.push_back(std::move(problem)); }

  std::vector<std::string> names_in(const Section& section) const;

  const Node& root_;
  Case& values_;
  Findings& findings_;
};

const KeyInfo* find_key_in(const Section& section, const std::string& name)
{
  const std::string path = section.pattern.empty() ? name : section.pattern + '.' + name;
  for (const KeyInfo& key : section.law_keys)
    if (key.path == path) return &key;
  return find_key(path);
}

std::vector<std::string> CaseReader::names_in(const Section& section) const
{
  if (section.pattern == "boundary") return sides_of_mesh(root_).value_or(std::vector<std::string>{});
  std::vector<std::string> names = names_in_section(section.pattern);
  for (const KeyInfo& key : section.law_keys) names.push_back(last_part(key.path));
  return names;
}

std::string title_of(const Section& section)
{
  if (!section.law.empty()) return fmt::format("material model `{}`", section.law);
  if (section.path.empty()) return "a case file";
  if (section.pattern == "boundary.SIDE") return "a side";
  return header_of(section.pattern.ends_with("[]") ? section.pattern : section.path);
}

/// True if the soil is another one below the phreatic line than above.
bool has_parts(const Node& material)
{
  const Node* density = find_item(material, "density");
  return find_item(material, "below") != nullptr || find_item(material, "above") != nullptr ||
         (density != nullptr && density->kind == NodeKind::table);
}

/// Whether a key must stand in this section; some depend on the other keys beside it.
bool is_required(const Section& section, const KeyInfo& key, const Node& root)
{
  if (section.pattern == "mesh") return is_needed(mesh_kind_of(section.table), last_part(key.path));
  if (key.path == "time.end")
    return find_item(section.table, "until") == nullptr && find_item(root, "flood") == nullptr;
  if (key.path == "body[].material") return find_item(section.table, "points") == nullptr;
  return key.required;
}

void CaseReader::read_section(const Section& section)
{
  std::vector<std::string> meant;
  for (const Node& item : section.table.items) {
    const std::string path = section.path_of(item);
    const std::string pattern = section.pattern.empty() ? item.name : section.pattern + '.' + item.name;
    const bool is_name = item.name.find_first_of(".[") == std::string::npos;  // no quoted "time.end" at the root
    if (!is_name) {
      report_unknown(section, item, meant);
    } else if (const KeyInfo* key = find_key_in(section, item.name)) {
      store_value({item, path, *key}, key->field(values_, section.number), findings_);
    } else if (const SectionInfo* list = find_section(pattern + "[]")) {
      read_list(item, path, *list);
    } else if (item.name == "material" && section.path.empty()) {
      read_materials(item);
    } else if (const SectionInfo* below = find_section(pattern)) {
      read_below(item, path, *below, section.number);
    } else {
      report_unknown(section, item, meant);
    }
  }
  report_missing(section, meant);
}

void CaseReader::read_below(const Node& node, const std::string& path, const SectionInfo& info, std::size_t number)
{
  if (!is_table(node, path, header_of(info.path))) return;
  if (info.path == "boundary")
    read_sides(node);
  else
    read_section({node, path, info.path, number});
}

void CaseReader::read_list(const Node& list, const std::string& path, const SectionInfo& info)
{
  const std::string header = header_of(info.path);
  if (list.kind != NodeKind::list)
    return report({path, fmt::format("`{}` must be a list of tables", list.name),
        fmt::format("Write {}, with two brackets, above each one.", header), topic_of(info.path), true});
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    count_entries(values_, info.path, true);
    const std::string entry = fmt::format("{}[{}]", path, k);
    if (is_table(list.items[k], entry, header)) read_section({list.items[k], entry, info.path, k});
  }
}

void CaseReader::read_materials(const Node& table)
{
  if (!is_table(table, "material", "[material.NAME]")) return;
  for (const Node& item : table.items) {
    const std::string path = join_path("material", item.name);
    if (!is_table(item, path, fmt::format("[{}]", path))) continue;
    if (has_parts(item))
      read_parts(item, path);
    else
      read_material(item, path);
  }
}

void CaseReader::read_material(const Node& table, const std::string& path)
{
  MaterialCase& material = values_.materials.emplace_back();
  material.name = table.name;
  read_law(table, {table, path, "material.NAME", values_.materials.size() - 1}, material);
}

/// table: of the section, which may be a copy that is gone later.
void CaseReader::read_law(const Node& table, Section section, MaterialCase& material)
{
  const Node* model = find_item(table, "model");
  const MaterialType* law = model != nullptr ? find_material(model->text) : nullptr;
  if (law == nullptr) {  // then the law's keys cannot be told from unknown ones: only the common ones are read
    Node common = table;
    std::erase_if(common.items, [](const Node& item) { return item.name != "model" && item.name != "density"; });
    return read_section(
        {common, section.path, section.pattern, section.number, {}, "", section.part, section.part_path});
  }
  material.parameters.assign(law->parameters.size(), std::numeric_limits<Real>::quiet_NaN());
  section.law_keys = keys_of_law(*law);
  section.law = std::string(law->name);
  material.ratios.resize(law->parameters.size());
  read_section(section);
  for (Problem& problem : complete_parameters(*law, material)) report(std::move(problem));
}

void CaseReader::read_parts(const Node& table, const std::string& path)
{
  bool good = true;
  for (const std::string& of : {std::string(), std::string("density")}) {
    const Node* holder = of.empty() ? &table : find_item(table, of);
    if (holder == nullptr || holder->kind != NodeKind::table) continue;
    const Node *below = find_item(*holder, "below"), *above = find_item(*holder, "above");
    if ((below == nullptr) == (above == nullptr) && (of.empty() || below != nullptr)) continue;
    good = false;
    if (below == nullptr && above == nullptr)
      report({join_path(path, of), "`density` cannot vary from place to place",
          "Got a table without `below` and `above`; allowed: a number, or { below = ..., above = ... }: of the soil "
          "below the phreatic line, and above it.",
          "material.density", true});
    else
      report({of.empty() ? path : join_path(path, of), "`below` and `above` belong together",
          "Give both: what the soil is below the phreatic line, and above it.", "material", true});
  }
  for (const char* name : {"below", "above"})
    if (const Node* part = find_item(table, name); part != nullptr && !is_table(*part, join_path(path, name), name))
      good = false;
  if (!good) {
    values_.materials.emplace_back().name = table.name;  // known to its bodies, so that they do not complain too
    return;
  }
  const std::size_t before = findings_.problems.size();
  read_part(table, Zone::below, path);
  const std::size_t first = findings_.problems.size();
  read_part(table, Zone::above, path);
  std::vector<Problem>& problems = findings_.problems;  // of keys that both parts share: once
  for (std::size_t k = problems.size(); k-- > first;)
    for (std::size_t other = before; other < first; ++other)
      if (problems[k].key == problems[other].key && problems[k].what == problems[other].what) {
        problems.erase(problems.begin() + static_cast<std::ptrdiff_t>(k));
        break;
      }
}

void CaseReader::read_part(const Node& table, Zone zone, const std::string& path)
{
  const std::string name = zone == Zone::below ? "below" : "above";
  const Node* part = find_item(table, name);
  Node joined = table;
  std::erase_if(joined.items, [&](const Node& item) {
    return item.name == "below" || item.name == "above" || (part != nullptr && find_item(*part, item.name) != nullptr);
  });
  for (Node& item : joined.items)
    if (item.name == "density" && item.kind == NodeKind::table) {
      item = Node(*find_item(item, name));
      item.name = "density";
    }
  if (part != nullptr) joined.items.insert(joined.items.end(), part->items.begin(), part->items.end());
  MaterialCase& material = values_.materials.emplace_back();
  material.name = table.name + ' ' + name;
  material.soil = table.name;
  material.zone = zone;
  read_law(joined, {joined, path, "material.NAME", values_.materials.size() - 1, {}, "", part, join_path(path, name)},
      material);
}

void CaseReader::read_sides(const Node& table)
{
  const Section boundary{table, "boundary", "boundary", 0};
  const auto sides = sides_of_mesh(root_);
  std::vector<std::string> meant;
  for (const Node& item : table.items) {
    if (sides && std::find(sides->begin(), sides->end(), item.name) == sides->end())
      report_unknown(boundary, item, meant);
    else
      read_side(item, join_path("boundary", item.name));
  }
}

void CaseReader::read_side(const Node& node, const std::string& path)
{
  values_.sides.emplace_back();
  const std::size_t number = values_.sides.size() - 1;
  values_.sides[number].side = node.name;
  const KeyInfo& kind = *find_key("boundary.SIDE");
  if (node.kind == NodeKind::text) {
    store_value({node, path, kind}, kind.field(values_, number), findings_);
  } else if (node.kind == NodeKind::table) {
    for (const SideKindInfo& info : side_kinds())  // those with a word follow from the value of their key
      if (!info.key.empty() && info.word.empty() && find_item(node, info.key) != nullptr)
        values_.sides[number].kind = info.kind;
    read_section({node, path, "boundary.SIDE", number});
  } else {
    report({path, fmt::format("`{}` must be text or a table", node.name),
        fmt::format(
            "Got {}; allowed: {} or a table with {}.", describe_value(node), allowed_text(kind), side_key_names()),
        "boundary"});
  }
}

bool CaseReader::is_table(const Node& node, const std::string& path, const std::string& header)
{
  if (node.kind == NodeKind::table) return true;
  const bool listed = node.kind == NodeKind::list;
  report({path, fmt::format("`{}` must be a table", path),
      fmt::format("Got {}; write {} {}.", listed ? "a list" : describe_value(node), header,
          listed ? "with one bracket" : "on a line of its own, its keys below"),
      topic_of(path), true});
  return false;
}

/// A key of that name in another section: "gravity" belongs to [forces], a parameter of a law to the materials of that
/// law, the name of a side to [boundary].
std::string hint_elsewhere(const Node& root, const std::string& name)
{
  const auto sides = sides_of_mesh(root);
  if (sides && std::ranges::find(*sides, name) != sides->end())
    return fmt::format("Did you mean `{}`, in [boundary]?\n", join_path("boundary", name));
  for (const KeyInfo& key : all_keys())
    if (last_part(key.path) == name && !parent_path(key.path).empty())
      return fmt::format("Did you mean `{}`, in {}?\n", key.path, header_of(parent_path(key.path)));
  const Node* materials = find_item(root, "material");
  for (std::size_t k = 0; materials != nullptr && k < materials->items.size(); ++k) {
    const Node& material = materials->items[k];
    const Node* model = find_item(material, "model");
    const MaterialType* law = model != nullptr ? find_material(model->text) : nullptr;
    if (law != nullptr && std::ranges::any_of(law->parameters,
                              [&](const auto& info) { return info.name == name || info.ratio.name == name; }))
      return fmt::format("Did you mean `{}`?\n", join_path(join_path("material", material.name), name));
  }
  return "";
}

void CaseReader::report_unknown(const Section& section, const Node& item, std::vector<std::string>& meant)
{
  auto names = names_in(section);
  const std::string nearest = closest(item.name, names);
  meant.push_back(nearest);
  if (!section.law.empty()) std::erase(names, "model");
  std::string detail =
      nearest.empty() ? hint_elsewhere(root_, item.name) : fmt::format("Did you mean `{}`?\n", nearest);
  detail += names.empty() ? "No side of this mesh has a name. Name them as in edges = { base = [0] } in [mesh]."
                          : fmt::format("Keys of {}: {}", title_of(section), plain_list(names));
  report({section.path_of(item), fmt::format("unknown key `{}`", item.name), detail,
      section.law.empty() ? topic_of(section.pattern) : section.law, true});
}

void CaseReader::report_missing(const Section& section, const std::vector<std::string>& meant)
{
  const auto is_missing = [&](const std::string& name) {
    return find_item(section.table, name) == nullptr && std::ranges::find(meant, name) == meant.end();
  };
  const bool has_stages = find_item(root_, "stage") != nullptr;  // they say when the run ends
  const auto check_key = [&](const KeyInfo& key) {
    const std::string name = last_part(key.path);
    if (parent_path(key.path) != section.pattern || !is_required(section, key, root_) || !is_missing(name)) return;
    if (key.path == "time.end" && has_stages) return;
    if (!key.instead.empty() && find_item(section.table, key.instead) != nullptr) return;
    const std::string others = key.path == "mesh.size" ? "\nKeys that belong together:\n" + mesh_kinds_text("  ") : "";
    report({section.path, fmt::format("the key `{}` is missing from {}", name, title_of(section)),
        fmt::format("Meaning: {}\nAllowed: {}{}", key.meaning, allowed_text(key), others),
        section.law.empty() ? topic_of(key.path) : section.law, true});
  };
  for (const KeyInfo& key : all_keys()) check_key(key);
  for (const KeyInfo& key : section.law_keys) check_key(key);
  for (const SectionInfo& below : all_sections())
    if (below.required && section.path.empty() && is_missing(last_part(below.path)) &&
        !(below.path == "time" && has_stages))
      report({"", fmt::format("the section {} is missing", header_of(below.path)),
          fmt::format("Meaning: {}\nKeys: {}{}", below.meaning, plain_list(names_in_section(below.path)),
              below.path == "material.NAME" ? ", and those of the model" : ""),
          topic_of(below.path)});
}

}  // namespace

void read_values(const Node& root, Case& values, Findings& findings)
{
  const Node* mesh = find_item(root, "mesh");
  if (mesh != nullptr) values.mesh.kind = mesh_kind_of(*mesh).kind;
  const Node* form = find_node(root, "method.as");
  if (form != nullptr && form->text == word_of(MethodForm::paper)) values.method = paper_options();
  CaseReader(root, values, findings).read_section({root, "", "", 0});
  if (!follow_series(values))
    findings.problems.push_back({"water.level", "no phreatic line follows from this level",
        "Bodies that come as points or cells have no outline. Give phreatic_line = [[0, \"level\"], [40, 0]] in the "
        "table of `level`,\nnumbers in m or formulas of level.",
        "water.level"});
  complete_situations(values.water);
  load_libraries(root, values, findings.problems);
  values.flood.given = find_item(root, "flood") != nullptr;
  set_end_of_run(root, values);
  set_start(root, values, findings);
}

}  // namespace terp
