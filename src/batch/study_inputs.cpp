// A key is known to name a file by its name alone, so a new key that names one must be added to names_a_file. Without
// it a change in that file is not seen, and a folder lacks its copy. One search serves both uses: it points into the
// tree, and the texts are replaced where they stand.

#include "batch/study_inputs.hpp"

#include "math/checksum.hpp"
#include "io/files/files.hpp"
#include "model/case/case.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace terp {
namespace {

using Nodes = std::vector<Node*>;

/// mesh.file, body[].points, `csv` of any field, and `library` of a law.
bool names_a_file(const std::string& key)
{
  const auto parts = split_path(key);
  if (parts.empty()) return false;
  return parts.back() == "csv" || parts.back() == "library" || (parts.front() == "mesh" && parts.back() == "file") ||
         (parts.front() == "body" && parts.back() == "points");
}

/// value: what the key of the case is set to.
void add_files(const std::string& key, Node& value, Nodes& found)
{
  if (value.kind == NodeKind::text && names_a_file(key)) found.push_back(&value);
  if (value.kind != NodeKind::table && value.kind != NodeKind::list) return;
  for (Node& item : value.items)
    add_files(value.kind == NodeKind::table ? join_path(key, item.name) : key, item, found);
}

std::string key_of(const Node& table)
{
  const Node* key = find_item(table, "key");
  return key != nullptr && key->kind == NodeKind::text ? key->text : "";
}

Nodes find_files(Node& study)
{
  Nodes found;
  const auto add_set = [&](Node* set) {
    if (set == nullptr) return;
    for (Node& item : set->items) add_files(item.name, item, found);
  };
  const auto add_tables = [&](const char* list, const char* name) {
    if (Node* tables = find_item(study, list))
      for (Node& table : tables->items)
        if (Node* value = find_item(table, name)) add_files(key_of(table), *value, found);
  };
  for (const char* section : {"set", "follow", "held"}) add_set(find_item(study, section));
  if (Node* load = find_item(study, "fragility")) add_set(find_item(*load, "set"));
  if (Node* estimator = find_item(study, "estimator")) add_set(find_item(*estimator, "coarse"));
  add_tables("field", "mean");
  add_tables("sweep", "values");
  return found;
}

}  // namespace

void name_digits_of_files(Node& study, const std::string& folder)
{
  for (Node* file : find_files(study)) file->text = digits_of(read_file(path_of(folder, file->text)));
}

std::vector<InputFile> name_copies_of_files(Node& study, const std::string& folder)
{
  std::vector<InputFile> files;
  for (Node* file : find_files(study)) {
    files.push_back({path_of(folder, file->text),
        fmt::format("study_file_{}{}", files.size() + 1, std::filesystem::path(file->text).extension().string())});
    file->text = files.back().copy;
  }
  return files;
}

}  // namespace terp
