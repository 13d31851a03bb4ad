// Each key of the table is asked for what the case has; velocities by formula are the exception, as functions have no
// text. A value that the earlier record lacks is no change if it is the default: a newer Terp may have more keys.

#include "io/case/case_record.hpp"

#include "math/checksum.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/keys.hpp"
#include "io/case/printable.hpp"
#include "io/case/units.hpp"
#include "model/bodies/points_csv.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace terp {
namespace {

constexpr std::array<std::string_view, 6> free_keys = {
    "title", "time.end", "time.at_most", "output.fields.every", "output.checkpoint.every", "output.checkpoint.keep"};
constexpr std::string_view equals = " = ";

/// Text without line feeds, and, as names of materials and sides may hold anything, without what stands between key and
/// value.
std::string on_one_line(const std::string& text)
{
  std::string line = printable(text);
  std::ranges::replace(line, '\n', ' ');
  return line;
}

std::string key_on_one_line(const std::string& key)
{
  std::string line = on_one_line(key);
  for (std::size_t at = line.find(equals); at != std::string::npos; at = line.find(equals)) line.erase(at, 1);
  return line;
}

class Recorder {
 public:
  Recorder(const Node& root, const Case& values) : root_(root), values_(values) {}

  void add(const std::string& key, const std::string& value, bool is_default = false)
  {
    if (!value.empty()) record_.push_back({key_on_one_line(key), on_one_line(value), is_default});
  }
  void add_keys();
  void add_outlines();
  void add_orders();
  void add_files();
  CaseRecord take() { return std::move(record_); }

 private:
  void add_key(const KeyInfo& key, const std::string& path, std::size_t number);
  void add_of_materials(const KeyInfo& key);
  void add_of_sides(const KeyInfo& key);

  const Node& root_;
  Case values_;
  CaseRecord record_;
};

/// Formulas as they stand in the file; empty if both are numbers.
std::string formulas_text(const Node& root, const std::string& path, const std::string& unit)
{
  const Node* list = find_node(root, path);
  if (list == nullptr || list->kind != NodeKind::list) return "";
  std::string text;
  bool is_formula = false;
  for (const Node& item : list->items) {
    const auto number = number_of(item, unit);
    is_formula |= !number;
    text += (text.empty() ? "" : ", ") + (number ? fmt::format("{}", *number) : quoted_list({item.text}));
  }
  return is_formula ? '[' + text + ']' : "";
}

void Recorder::add_key(const KeyInfo& key, const std::string& path, std::size_t number)
{
  const Field field = key.field(values_, number);
  std::string value = std::holds_alternative<VelocityPair>(field) ? formulas_text(root_, path, key.unit) : "";
  if (value.empty()) value = value_text(key, field);
  add(path, value, key.default_text == value || key.default_text == value + ' ' + key.unit);
}

/// The rest of the path may lead through a section of the material.
void Recorder::add_of_materials(const KeyInfo& key)
{
  const std::string rest = key.path.substr(std::string_view("material.NAME.").size());
  for (std::size_t k = 0; k < values_.materials.size(); ++k)
    add_key(key, material_path(values_.materials[k]) + '.' + rest, k);
}

void Recorder::add_of_sides(const KeyInfo& key)
{
  for (std::size_t k = 0; k < values_.sides.size(); ++k) {
    const std::string side = join_path("boundary", values_.sides[k].side);
    add_key(key, key.path == "boundary.SIDE" ? side : join_path(side, last_part(key.path)), k);
  }
}

void Recorder::add_keys()
{
  for (const KeyInfo& key : all_keys()) {
    if (key.path == "mesh.file" || key.path == "body[].points") continue;    // add_files
    if (key.path == "method.as") continue;                                   // the options say it
    if (key.path == "body[].box" || key.path == "body[].polygon") continue;  // one place for two keys: add_outlines
    const std::string section = parent_path(key.path);
    if (const auto n = count_entries(values_, section, false))
      for (std::size_t k = 0; k < *n; ++k)
        add_key(key, fmt::format("{}[{}].{}", topic_of(section), k, last_part(key.path)), k);
    else if (key.path.starts_with("material.NAME"))
      add_of_materials(key);
    else if (key.path.starts_with("boundary.SIDE"))
      add_of_sides(key);
    else
      add_key(key, key.path, 0);
  }
  for (std::size_t k = 0; k < values_.materials.size(); ++k)
    for (const KeyInfo& key : keys_of_law(*find_material(values_.materials[k].model)))
      if (key.path != "material.NAME.library")  // add_files
        add_key(key, join_path(material_path(values_.materials[k]), last_part(key.path)), k);
}

void Recorder::add_outlines()
{
  const KeyInfo& key = *find_key("body[].polygon");
  for (std::size_t k = 0; k < values_.bodies.size(); ++k)
    add(fmt::format("body[{}] (outline)", k), value_text(key, key.field(values_, k)));
}

void Recorder::add_orders()
{
  std::vector<std::string> materials, sides;
  for (const MaterialCase& m : values_.materials) materials.push_back(m.name);
  for (const SideCondition& s : values_.sides) sides.push_back(s.side);
  add("material (in order)", plain_list(materials));
  add("body (number)", fmt::format("{}", values_.bodies.size()));
  add("boundary (in order)", plain_list(sides));
}

/// Of the points that the solver takes from a table: comments, blanks and the order of its columns leave no trace.
std::string points_key(const std::string& path)
{
  std::string bytes;
  for (const CsvPoint& point : read_points_csv(path)) {
    for (const Real value : {point.x[0], point.x[1], point.volume})
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    bytes += point.material + '\n';
  }
  return digits_of(bytes);
}

void Recorder::add_files()
{
  if (!values_.mesh.file.empty())
    add("mesh.file (content)", digits_of(read_file(path_of(values_.folder, values_.mesh.file))));
  for (std::size_t k = 0; k < values_.bodies.size(); ++k)
    if (const std::string& name = values_.bodies[k].points_file; !name.empty())
      add(fmt::format("body[{}].points (content)", k), points_key(path_of(values_.folder, name)));
  for (const MaterialCase& material : values_.materials)
    if (material.from_library != nullptr)
      add(join_path(material_path(material), "library (content)"),
          digits_of(read_file(path_of(values_.folder, material.library.file))));
}

std::string cells_key(const Mesh<2>& mesh)
{
  return digits_of({reinterpret_cast<const char*>(mesh.cells.data()), mesh.cells.size() * sizeof mesh.cells[0]});
}

CaseRecord parse_record(const std::string& text)
{
  CaseRecord record;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t at = line.find(equals); at != std::string::npos)
      record.push_back({line.substr(0, at), line.substr(at + equals.size())});
  return record;
}

const RecordedValue* find_value(const CaseRecord& record, std::string_view key)
{
  const auto found = std::ranges::find_if(record, [&](const RecordedValue& v) { return v.key == key; });
  return found == record.end() ? nullptr : &*found;
}

}  // namespace

std::string text_of_keys(const Node& root, const Case& values)
{
  Recorder recorder(root, values);
  recorder.add_keys();
  recorder.add_outlines();
  return record_text(recorder.take());
}

CaseRecord make_case_record(const CaseFile& file, const Mesh<2>& mesh)
{
  Recorder recorder(file.source.root, file.values);
  recorder.add_keys();
  recorder.add_outlines();
  recorder.add_orders();
  recorder.add_files();
  if (file.values.mesh.kind == MeshKind::polygon) recorder.add("mesh (cells)", cells_key(mesh));
  return recorder.take();
}

std::string record_text(const CaseRecord& record)
{
  std::string text;
  for (const RecordedValue& v : record) text += fmt::format("{}{}{}\n", v.key, equals, v.value);
  return text;
}

std::string value_in_record(const std::string& text, std::string_view key)
{
  const CaseRecord record = parse_record(text);
  const RecordedValue* found = find_value(record, key);
  return found == nullptr ? "" : found->value;
}

std::string ChangedValue::text() const
{
  constexpr std::size_t longest = 60;
  if (std::max(before.size(), now.size()) > longest) return key;
  const auto shown = [](const std::string& value) { return value.empty() ? "not set" : value; };
  return fmt::format("{} ({}, now {})", key, shown(before), shown(now));
}

std::vector<ChangedValue> changes_since(const std::string& text, const CaseRecord& now)
{
  const CaseRecord before = parse_record(text), after = parse_record(record_text(now));
  std::vector<ChangedValue> changes;
  for (const RecordedValue& v : before)
    if (const RecordedValue* there = find_value(after, v.key); there == nullptr || there->value != v.value)
      changes.push_back({v.key, v.value, there == nullptr ? "" : there->value});
  for (std::size_t k = 0; k < now.size(); ++k)
    if (find_value(before, after[k].key) == nullptr && !now[k].is_default)
      changes.push_back({after[k].key, "", after[k].value});
  return changes;
}

bool may_change_on_resume(std::string_view key) { return std::ranges::find(free_keys, key) != free_keys.end(); }

}  // namespace terp
