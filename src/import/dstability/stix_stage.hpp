// A file of D-Stability with one stage more: the members of the file as they are, and copies of those of a stage with
// other layers and water. Not for: where the layers come from (stix_export.hpp), reading (read_stix.hpp).
#pragma once

#include "import/dstability/project.hpp"
#include "model/bodies/polygon.hpp"
#include "model/water/water_case.hpp"

#include <optional>

namespace terp {

struct StageLayer {
  std::string label, soil_id;
  Polygon outline;  ///< [m]
};

struct WaterOfLines {
  WaterSituation situation;  ///< of lines
  Real unit_weight = 0.0;    ///< [N/m^3]
};

struct AddedStage {
  std::size_t scenario = 0, after = 0;  ///< that it follows, numbers from 0 as in StixProject
  std::string label;
  std::vector<StageLayer> layers;
  std::optional<WaterOfLines> water;  ///< none: that of the stage before it
};

/// The bytes of a .stix file: of data model 2 with a new scenario of copies of the stages up to that one, and the added
/// one as its last; of data model 1 with a last stage. It has no loads, states, excavations and reinforcements of its
/// own, and no results. Throws InputError if the file is damaged, or a later stage of data model 1 is there.
std::string with_added_stage(std::string bytes, const std::string& path, const AddedStage& added);

}  // namespace terp
