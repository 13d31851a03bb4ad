// One telling key decides the kind of mesh, in a fixed order: file, polygon, sides, cells, and else the plain
// rectangle. So keys that contradict each other still give one kind, and a message can say which keys do not belong to
// it. The table stands in the order of MeshKind, by which it is indexed.

#include "io/case/mesh_kinds.hpp"

#include "io/case/key_text.hpp"
#include "io/case/keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

bool holds(const std::vector<std::string>& keys, const std::string& key)
{
  return std::ranges::find(keys, key) != keys.end();
}

std::string line_of_kind(const MeshKindInfo& info)
{
  const std::string more = info.optional.empty() ? "" : fmt::format(" ({})", plain_list(info.optional));
  return fmt::format("{}{}: {}", plain_list(info.needed), more, info.meaning);
}

}  // namespace

const std::vector<MeshKindInfo>& all_mesh_kinds()
{
  static const std::vector<MeshKindInfo> kinds = {
      {MeshKind::rectangle, "a rectangle of equal cells", {"size", "cell"}, {"origin"}},
      {MeshKind::graded, "a graded rectangle", {"size", "cells"}, {"grading", "origin"}},
      {MeshKind::mapped, "a grid between four sides", {"sides", "cells"}, {"grading"}},
      {MeshKind::file, "a mesh from a file", {"file"}, {}},
      {MeshKind::polygon, "a mesh from a polygon", {"polygon", "cell"},
          {"edges", "refine", "follow_bodies", "variant"}},
  };
  return kinds;
}

const MeshKindInfo& mesh_kind_of(const Node& mesh)
{
  const auto has = [&](const char* key) { return find_item(mesh, key) != nullptr; };
  const auto info = [](MeshKind kind) -> const MeshKindInfo& { return all_mesh_kinds().at(static_cast<int>(kind)); };
  if (has("file")) return info(MeshKind::file);
  if (has("polygon")) return info(MeshKind::polygon);
  if (has("sides")) return info(MeshKind::mapped);
  return info(has("cells") ? MeshKind::graded : MeshKind::rectangle);
}

bool is_needed(const MeshKindInfo& info, const std::string& key) { return holds(info.needed, key); }

bool is_allowed(const MeshKindInfo& info, const std::string& key)
{
  return is_needed(info, key) || holds(info.optional, key);
}

std::string mesh_kinds_text(const std::string& margin)
{
  std::string text;
  for (const MeshKindInfo& info : all_mesh_kinds()) text += (text.empty() ? "" : "\n") + margin + line_of_kind(info);
  return text;
}

std::optional<std::vector<std::string>> sides_of_mesh(const Node& root)
{
  const Node* mesh = find_item(root, "mesh");
  const MeshKind kind = mesh == nullptr ? MeshKind::rectangle : mesh_kind_of(*mesh).kind;
  if (kind == MeshKind::file) return std::nullopt;
  if (kind != MeshKind::polygon) return side_names();
  std::vector<std::string> names;
  if (const Node* edges = find_item(*mesh, "edges"))
    for (const Node& side : edges->items) names.push_back(side.name);
  return names;
}

}  // namespace terp
