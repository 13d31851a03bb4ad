// Help from the same tables that read the case file: for people, and for their editors.
#pragma once

#include <string>

namespace terp {

/// What a material model, scheme, key or section means: unit, allowed values, default, equation. A key is given dotted
/// ("mesh.cell", "material.clay.eta") or by its last part. Throws CaseError with the nearest topic if there is none.
std::string explain(const std::string& topic);

/// Materials, schemes and output fields of this build.
std::string list();

/// What `terp schema` prints: the table of keys as a JSON Schema of the case file (draft 7), with which editors
/// complete keys, show their meaning and mark what is wrong. Not for: what keys contradict among each other.
std::string case_schema();

}  // namespace terp
