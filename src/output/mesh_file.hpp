// mesh.vtkhdf: the background mesh and, if asked for, what it carries at the output times (docs/formats.md).
// Not for: restarting a run; a mesh as input (gmsh's files).
#pragma once

#include "mesh/mesh.hpp"
#include "output/hdf5_file.hpp"
#include "simulation/mesh_frame.hpp"
#include "simulation/observer.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace terp {

/// The file is closed between frames, as results.vtkhdf is.
class MeshFile {
 public:
  /// Touches nothing. run: digits of its case, which go into a new file.
  explicit MeshFile(std::string path, std::string run = {}) : path_(std::move(path)), run_(std::move(run)) {}

  /// Nodes and cells; with_steps: frames may follow.
  void create(const Mesh<2>& mesh, bool with_steps) const;

  /// Adds what the mesh carries at one time.
  void append(const MeshFrame& frame) const;

  /// Frames of steps up to `step`; 0 without a file.
  std::int64_t count_until(std::int64_t step) const;

  /// The file, ready for `cut_after`; nothing without a file. What is done to it is on the disk when it is closed, and
  /// dropped otherwise.
  std::unique_ptr<Hdf5File> open_to_cut() const;

  /// Drops the frames of later steps, if it has any.
  static void cut_after(Hdf5File& file, std::int64_t step);

 private:
  std::string path_, run_;
};

/// Writes mesh.vtkhdf into the folder of a run: the mesh at once, unless it is there, and with `output.mesh` what it
/// carries whenever a frame of the points is shown. In the run's own thread: it looks at the state, and is small
/// against a frame.
class MeshWriter : public Observer {
 public:
  /// case_record: what the run began with.
  MeshWriter(const std::string& folder, const std::string& case_record, const Model& model, const State& state);

  void frame(const std::shared_ptr<const Frame>& frame) override;

 private:
  MeshFile file_;
  const Model& model_;
  const State& state_;
  std::int64_t last_step_ = -1;  // a frame may be shown in parts
};

}  // namespace terp
