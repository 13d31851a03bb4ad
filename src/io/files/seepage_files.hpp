// The files of `terp seepage` (docs/seepage.md): flows, uplift, heads along a line, the water of a moment, a picture.
// Not for: computing them (model/seepage).
#pragma once

#include "model/seepage/seepage_results.hpp"
#include "run/loop/simulation.hpp"

#include <string>
#include <vector>

namespace terp {

class SeepageFiles {
 public:
  /// The section and its mesh must outlive it. of: the first column of its tables, "situation" or "hours".
  SeepageFiles(std::string folder, const Mesh<2>& mesh, const SeepageSection& section, const std::string& of);

  /// Rows of seepage.csv.
  void add_flows(const std::string& when, const SeepageCase& conditions, const ComputedWater& water);
  /// Rows of uplift.csv.
  void add_uplift(const std::string& situation, const std::vector<UpliftPlace>& places);
  /// Rows of along.csv. line: x and y of both ends [m]; unit_weight: of water [N/m^3].
  void add_along(
      const std::string& situation, const ComputedWater& water, const std::vector<double>& line, Real unit_weight);
  /// Rows of tables.csv.
  void add_table(const std::string& hours, const ComputedWater& water);
  /// heads_NAME.csv, on a grid that a case can take, and table_NAME.csv.
  void write_water(const std::string& name, const SeepageCase& conditions, const ComputedWater& water) const;
  /// seepage_NAME.svg: the section of a simulation whose standing water this is, with lines of equal head and of flow.
  void write_picture(
      const std::string& name, const Simulation& simulation, const ComputedWater& water, Real band) const;
  /// water.toml: the water of names whose heads are written, for a case.
  void write_for_case(const std::vector<std::string>& names) const;
  /// The tables that have rows.
  void write_tables() const;

 private:
  void write(const std::string& name, std::string_view text) const;

  /// A table of the folder; n_header: length of its header.
  struct Table {
    const char* file;
    std::string text;
    std::size_t n_header = text.size();
  };

  const std::string folder_;
  const Mesh<2>& mesh_;
  const SeepageSection& section_;
  Table flows_, uplift_, along_, tables_;
};

}  // namespace terp
