// mesh.vtkhdf, the background mesh, and, if asked for, frames of what it carries (docs/formats.md).
// Not for: restarting a run; a mesh as input (gmsh's files).
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "io/files/frame_files.hpp"
#include "run/report/mesh_frame.hpp"
#include "run/loop/observer.hpp"

#include <string>

namespace terp {

/// run: digits of its case.
void write_mesh(const std::string& path, const Mesh<2>& mesh, const std::string& run);

/// Nodes, cells and what follows from them, without names. Throws FileError.
Mesh<2> read_mesh(const std::string& path);

/// Writes mesh.vtkhdf into the folder of a run, unless it is there, and with `output.mesh` what the mesh carries
/// whenever a frame of the points is shown. In the run's own thread: it looks at the state, and is small against a
/// frame.
class MeshWriter : public Observer {
 public:
  /// frames: where they go on.
  MeshWriter(const std::string& folder, FrameSeries& frames, const Model& model, const State& state);

  void frame(const std::shared_ptr<const Frame>& frame) override;

 private:
  FrameSeries& frames_;
  const Model& model_;
  const State& state_;
  std::int64_t last_step_ = -1;  // a frame may be shown in parts
};

}  // namespace terp
