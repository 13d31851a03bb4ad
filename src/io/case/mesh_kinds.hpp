// Which keys of [mesh] belong together: the kind of mesh follows from the keys that are given.
// Not for: their values (check_case.hpp).
#pragma once

#include "io/case/document.hpp"
#include "model/case/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace terp {

struct MeshKindInfo {
  MeshKind kind = MeshKind::rectangle;
  std::string meaning;              ///< "a rectangle of equal cells"
  std::vector<std::string> needed;  ///< keys
  std::vector<std::string> optional;
};

const std::vector<MeshKindInfo>& all_mesh_kinds();

/// The kind that the keys of [mesh] speak of, contradictory or not.
const MeshKindInfo& mesh_kind_of(const Node& mesh);

bool is_needed(const MeshKindInfo& info, const std::string& key);
bool is_allowed(const MeshKindInfo& info, const std::string& key);

/// One line for each kind with its keys, each behind the margin; those that may be left out in brackets.
std::string mesh_kinds_text(const std::string& margin);

/// Names that [boundary] may hold; none if only the mesh file knows them.
std::optional<std::vector<std::string>> sides_of_mesh(const Node& root);

}  // namespace terp
