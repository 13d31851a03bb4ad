// Messages about a mesh that name the location: the error, and the names of cells and nodes in it.
#pragma once

#include "mpm/mesh/mesh.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace terp {

/// The mesh or its file cannot be used. The text has every fault found, up to ten, and what to do.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A coordinate [m] to the millimetre, or to six digits if these say more, without zeros at its end: "121300.25".
std::string coordinate_text(Real x);

/// "(121300.25, 0.4)".
std::string place_text(Vec<2> x);

/// "cell 412", with the mesh file's own number where there is one: "cell 412 (element 1033 of the file)".
std::string cell_name(const Mesh<2>& mesh, Index cell);

/// "node 57 at (3.1, 0.4) m"; the mesh file's own number where there is one.
std::string node_name(const Mesh<2>& mesh, Index node);

/// All four corners of a cell: "nodes 57 at (3.1, 0.4), ... m".
std::string corner_names(const Mesh<2>& mesh, Index cell);

/// Collects faults: shows the first ten, counts the rest, gives each advice once.
class MeshFaults {
 public:
  /// title: what has the faults, e.g. "the mesh".
  explicit MeshFaults(std::string title) : title_(std::move(title)) {}
  /// what: one line on what is wrong and where, without full stop. places: nodes and coordinates; may be empty.
  /// advice: a sentence on what to do; may be empty.
  /// The thousandth fault stops at once, to save time.
  void add(const std::string& what, const std::string& places, const std::string& advice);
  /// Counts faults that are not shown.
  void count_more(std::int64_t n) { n_ += n; }
  bool empty() const { return n_ == 0; }
  /// Throws MeshError if there is any.
  void stop_if_any() const;

 private:
  std::string title_;
  std::int64_t n_ = 0, n_shown_ = 0;
  std::string text_;
  std::vector<std::string> advice_;
};

}  // namespace terp
