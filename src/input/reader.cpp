#include "input/reader.hpp"

#include "base/closest.hpp"
#include "input/key_text.hpp"
#include "input/mesh_kinds.hpp"
#include "input/side_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

void add_entry(const std::string& pattern, Case& values)
{
  if (pattern == "body[]")
    values.bodies.emplace_back();
  else if (pattern == "footing[]")
    values.footings.emplace_back();
  else
    values.mesh.refine.emplace_back();
}

/// Whether a key must stand in this section; some depend on the other keys beside it.
bool is_required(const Section& section, const KeyInfo& key)
{
  if (section.pattern == "mesh") return is_needed(mesh_kind_of(section.table), last_part(key.path));
  if (key.path == "body[].material") return find_item(section.table, "points") == nullptr;
  return key.required;
}

void CaseReader::read_section(const Section& section)
{
  std::vector<std::string> meant;
  for (const Node& item : section.table.items) {
    const std::string path = join_path(section.path, item.name);
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
    add_entry(info.path, values_);
    const std::string entry = fmt::format("{}[{}]", path, k);
    if (is_table(list.items[k], entry, header)) read_section({list.items[k], entry, info.path, k});
  }
}

void CaseReader::read_materials(const Node& table)
{
  if (!is_table(table, "material", "[material.NAME]")) return;
  for (const Node& item : table.items) {
    const std::string path = join_path("material", item.name);
    if (is_table(item, path, fmt::format("[{}]", path))) read_material(item, path);
  }
}

void CaseReader::read_material(const Node& table, const std::string& path)
{
  const Node* model = find_item(table, "model");
  const MaterialType* law = model != nullptr ? find_material(model->text) : nullptr;
  MaterialCase& material = values_.materials.emplace_back();
  material.name = table.name;
  const std::size_t number = values_.materials.size() - 1;
  if (law == nullptr) {  // then the law's keys cannot be told from unknown ones: only the common ones are read
    Node common = table;
    std::erase_if(common.items, [](const Node& item) { return item.name != "model" && item.name != "density"; });
    return read_section({common, path, "material.NAME", number});
  }
  material.parameters.assign(law->parameters.size(), std::numeric_limits<Real>::quiet_NaN());
  read_section({table, path, "material.NAME", number, keys_of_law(*law), std::string(law->name)});
  material.parameters = law->complete(material.parameters);
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

/// A key of that name in another section: "gravity" belongs to [forces].
std::string hint_elsewhere(const std::string& name)
{
  for (const KeyInfo& key : all_keys())
    if (last_part(key.path) == name && !parent_path(key.path).empty())
      return fmt::format("Did you mean `{}`, in {}?\n", key.path, header_of(parent_path(key.path)));
  return "";
}

void CaseReader::report_unknown(const Section& section, const Node& item, std::vector<std::string>& meant)
{
  auto names = names_in(section);
  const std::string nearest = closest(item.name, names);
  meant.push_back(nearest);
  if (!section.law.empty()) std::erase(names, "model");
  std::string detail = nearest.empty() ? hint_elsewhere(item.name) : fmt::format("Did you mean `{}`?\n", nearest);
  detail += names.empty() ? "No side of this mesh has a name. Name them as in edges = { base = [0] } in [mesh]."
                          : fmt::format("Keys of {}: {}", title_of(section), plain_list(names));
  report({join_path(section.path, item.name), fmt::format("unknown key `{}`", item.name), detail,
      section.law.empty() ? topic_of(section.pattern) : section.law, true});
}

void CaseReader::report_missing(const Section& section, const std::vector<std::string>& meant)
{
  const auto is_missing = [&](const std::string& name) {
    return find_item(section.table, name) == nullptr && std::ranges::find(meant, name) == meant.end();
  };
  const auto check_key = [&](const KeyInfo& key) {
    const std::string name = last_part(key.path);
    if (parent_path(key.path) != section.pattern || !is_required(section, key) || !is_missing(name)) return;
    const std::string others = key.path == "mesh.size" ? "\nKeys that belong together:\n" + mesh_kinds_text("  ") : "";
    report({section.path, fmt::format("the key `{}` is missing from {}", name, title_of(section)),
        fmt::format("Meaning: {}\nAllowed: {}{}", key.meaning, allowed_text(key), others),
        section.law.empty() ? topic_of(key.path) : section.law, true});
  };
  for (const KeyInfo& key : all_keys()) check_key(key);
  for (const KeyInfo& key : section.law_keys) check_key(key);
  for (const SectionInfo& below : all_sections())
    if (below.required && section.path.empty() && is_missing(last_part(below.path)))
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
  CaseReader(root, values, findings).read_section({root, "", "", 0});
}

}  // namespace terp
