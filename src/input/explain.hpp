// The help on single topics, from the same tables that read the case file.
#pragma once

#include <string>

namespace terp {

/// What a material model, scheme, key or section means: unit, allowed values, default, equation. A key is given dotted
/// ("mesh.cell", "material.clay.eta") or by its last part. Throws CaseError with the nearest topic if there is none.
std::string explain(const std::string& topic);

/// Materials, schemes and output fields of this build.
std::string list();

}  // namespace terp
