// The water of a case folder: tables of the stages, their grids, what is told of them.
// Not for: how the water of one stage is said (water_text.hpp), the level of the river (river_level.hpp).
#pragma once

#include "import/dstability/section.hpp"
#include "import/dstability/section_layout.hpp"
#include "import/dstability/water_text.hpp"

#include <string>
#include <utility>
#include <vector>

namespace terp {

struct FolderWater {
  std::vector<CaseTableText> tables = {};
  std::vector<std::pair<std::string, std::string>> files = {};
  std::vector<std::string> notes = {};
  std::vector<Sentence> assumed = {};
  std::string situation = {};         ///< of the analysed stage; empty: it is that of the start
  std::vector<Vec<2>> phreatic = {};  ///< of the analysed stage; empty: there is no water

  void add(const WaterText& water, const std::string& header, const std::string& comment, std::vector<CaseLine> lines,
      Real cell);
};

/// Of the first stage and the analysed one; staged: they are two. taken: a name that no situation may have.
FolderWater water_of_stages(const StixSection& now, const StixSection& first, const SectionLayout& layout, bool staged,
    const std::string& taken);

}  // namespace terp
