// mesh.vtkhdf: the background mesh and, if asked for, what it carries at the output times (docs/formats.md).
// Not for: restarting a run; a mesh as input (gmsh's files).
#pragma once

#include "mesh/mesh.hpp"
#include "simulation/mesh_frame.hpp"
#include "simulation/observer.hpp"

#include <cstdint>
#include <string>

namespace terp {

/// The file is closed between frames, as results.vtkhdf is.
class MeshFile {
 public:
  /// Touches nothing.
  explicit MeshFile(std::string path) : path_(std::move(path)) {}

  /// Nodes and cells; with_steps: frames may follow.
  void create(const Mesh<2>& mesh, bool with_steps) const;

  /// Adds what the mesh carries at one time.
  void append(const MeshFrame& frame) const;

  /// Frames of steps up to `step`; 0 without a file.
  std::int64_t count_until(std::int64_t step) const;

  /// Drops the frames of later steps.
  void truncate_after(std::int64_t step) const;

 private:
  std::string path_;
};

/// Writes mesh.vtkhdf into the folder of a run: the mesh at once, unless it is there, and with `output.mesh` what it carries whenever a
/// frame of the points is shown. In the run's own thread: it looks at the state, and is small against a frame.
class MeshWriter : public Observer {
 public:
  MeshWriter(const std::string& folder, const Model& model, const State& state);

  void frame(const std::shared_ptr<const Frame>& frame) override;

 private:
  MeshFile file_;
  const Model& model_;
  const State& state_;
  std::int64_t last_step_ = -1;  // a frame may be shown in parts
};

}  // namespace terp
