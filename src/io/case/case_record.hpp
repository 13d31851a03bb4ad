// What a run began with, value by value as the solver takes them: kept in its checkpoints, so that a run that goes on
// is still the same run. Comments, the order of keys, spelling (8e3 or 8000) and defaults that are written out leave no
// trace in it.
#pragma once

#include "io/case/case_file.hpp"
#include "mpm/mesh/mesh.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace terp {

struct RecordedValue {
  std::string key;          ///< "material.clay.eta"; "mesh.file (content)"
  std::string value;        ///< "4.5", or of a file 16 digits that depend on all of its content
  bool is_default = false;  ///< an older Terp without this key is taken to have had this value
};
using CaseRecord = std::vector<RecordedValue>;

/// Of a case with its mesh. Files count by what is in them, wherever they lie: mesh files by every byte, tables by the
/// points that they give; a mesh from a polygon by its cells, as gmsh made it. The order of materials, bodies and sides
/// counts: points are numbered by it. Throws FileError if a file cannot be read.
CaseRecord make_case_record(const CaseFile& file, const Mesh<2>& mesh);

/// The same without what is in files, as "key = value" per line: of a case before it has a mesh.
std::string text_of_keys(const Node& root, const Case& values);

/// "key = value" per line.
std::string record_text(const CaseRecord& record);

/// The value of a key in the text of a record; empty if it has none.
std::string value_in_record(const std::string& text, std::string_view key);

struct ChangedValue {
  std::string key, before, now;  ///< an empty text: not set

  std::string text() const;  ///< "mesh.cell (0.1, now 0.2)"
};

/// What changed since the record with that text was made.
std::vector<ChangedValue> changes_since(const std::string& text, const CaseRecord& now);

/// Whether a run may go on with another value of this key: what was written so far, and what comes, stay as they would
/// be.
bool may_change_on_resume(std::string_view key);

}  // namespace terp
