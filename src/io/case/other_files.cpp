// Every key that names a file is found by find_file_keys, for checks and for copies. A new one must be added there, or
// its file is missing from the run folder and the run cannot be moved or resumed.

#include "io/case/other_files.hpp"

#include "math/closest.hpp"
#include "model/case/case.hpp"
#include "os/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace terp {
namespace {

namespace fs = std::filesystem;

/// Keys `csv` and `library` at any depth of a table.
void add_named_files(const std::string& path, Node& table, std::vector<std::pair<std::string, Node*>>& found)
{
  for (Node& item : table.items) {
    const std::string at = join_path(path, item.name);
    if ((item.name == "csv" || item.name == "library") && item.kind == NodeKind::text) found.emplace_back(at, &item);
    if (item.kind == NodeKind::table) add_named_files(at, item, found);
    for (std::size_t k = 0; item.kind == NodeKind::list && k < item.items.size(); ++k)
      if (item.items[k].kind == NodeKind::table) add_named_files(fmt::format("{}[{}]", at, k), item.items[k], found);
  }
}

std::vector<std::pair<std::string, Node*>> find_file_keys(Node& root)
{
  std::vector<std::pair<std::string, Node*>> found;
  const auto add = [&](const std::string& path, Node& table, const char* name) {
    Node* node = find_item(table, name);
    if (node != nullptr && node->kind == NodeKind::text) found.emplace_back(path + '.' + name, node);
  };
  if (Node* mesh = find_item(root, "mesh")) add("mesh", *mesh, "file");
  if (Node* bodies = find_item(root, "body"))
    for (std::size_t k = 0; bodies->kind == NodeKind::list && k < bodies->items.size(); ++k)
      add(fmt::format("body[{}]", k), bodies->items[k], "points");
  if (Node* reference = find_item(root, "reference")) add("reference", *reference, "imported");
  for (const char* section : {"material", "water"})
    if (Node* table = find_item(root, section)) add_named_files(section, *table, found);
  if (Node* stages = find_item(root, "stage"))
    for (std::size_t k = 0; stages->kind == NodeKind::list && k < stages->items.size(); ++k)
      if (Node* set = find_item(stages->items[k], "set")) add_named_files(fmt::format("stage[{}].set", k), *set, found);
  return found;
}

bool is_table_of_values(const std::string& path) { return path.ends_with(".csv"); }
bool is_record_of_import(const std::string& path) { return path == "reference.imported"; }
bool is_library(const std::string& path) { return path.ends_with(".library"); }

fs::path absolute_path(const std::string& folder, const std::string& name)
{
  std::error_code error;
  const fs::path path = fs::absolute(fs::path(folder) / name), real = fs::weakly_canonical(path, error);
  return error ? path : real;
}

/// The ending says how a mesh file is read; one that says nothing is taken for gmsh's.
std::string copy_of_mesh(const std::string& path)
{
  const std::string name = "mesh" + fs::path(path).extension().string();
  const bool known = std::ranges::find(mesh_copies, name) != std::end(mesh_copies);
  return known ? name : std::string(mesh_copies[0]);
}

}  // namespace

std::string fault_of_file(const std::string& path)
{
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return "this is a folder, not a file";
  if (!fs::exists(path, ignored)) return "there is no such file";
  if (!fs::is_regular_file(path, ignored)) return "this is no ordinary file";
  const int error = may_read(path);
  return error == 0 ? "" : "the file cannot be read: " + words_of_errno(error);
}

void check_files(const Node& root, const std::string& folder, std::vector<Problem>& problems)
{
  Node copy = root;
  for (const auto& [path, node] : find_file_keys(copy)) {
    const fs::path file = fs::path(folder) / node->text;
    const std::string fault = fault_of_file(file.string());
    if (fault.empty()) continue;
    const std::string ending = path == "mesh.file"         ? ".msh"
                               : is_library(path)          ? ".so"
                               : is_record_of_import(path) ? ".toml"
                                                           : ".csv";
    std::error_code ignored;
    const std::string similar = fs::exists(file, ignored) ? "" : similar_file(file.string(), ending);
    std::string detail =
        similar.empty() ? "" : fmt::format("Did you mean `{}`?\n", fs::path(similar).filename().string());
    if (is_record_of_import(path)) detail += "Without the record of the import take `imported` out of [reference].\n";
    detail +=
        fmt::format("Looked for {}; names are relative to the case file.", absolute_path(folder, node->text).string());
    problems.push_back({path, fault, detail,
        path == "mesh.file" || is_record_of_import(path) ? path
        : is_table_of_values(path)                       ? "field"
        : is_library(path)                               ? "library"
                                                         : "body.points"});
  }
}

bool name_copies(Node& root, const std::string& folder, std::vector<InputFile>& files)
{
  bool changed = false;
  int n_points = 0, n_values = 0, n_libraries = 0;
  for (const auto& [path, node] : find_file_keys(root)) {
    const std::string copy = path == "mesh.file"         ? copy_of_mesh(node->text)
                             : is_table_of_values(path)  ? fmt::format("values_{}.csv", ++n_values)
                             : is_library(path)          ? fmt::format("library_{}.so", ++n_libraries)
                             : is_record_of_import(path) ? std::string(copy_of_import)
                                                         : fmt::format("points_{}.csv", ++n_points);
    files.push_back({path_of(folder, node->text), copy});
    changed |= node->text != copy;
    node->text = copy;
  }
  return changed;
}

std::string similar_file(const std::string& path, const std::string& ending)
{
  const fs::path missing(path);
  std::error_code ignored;
  std::vector<std::string> names;
  const fs::path folder = missing.has_parent_path() ? missing.parent_path() : fs::path(".");
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ending) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  const std::string nearest = closest(missing.filename().string(), names);
  return nearest.empty() ? nearest : (missing.parent_path() / nearest).string();
}

}  // namespace terp
