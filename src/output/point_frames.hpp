// Frames of all material points, as ParaView and h5py read them (docs/formats.md).
// Not for: restarting a run (checkpoint); where the files lie (frame_files).
#pragma once

#include "output/frame_files.hpp"
#include "simulation/observer.hpp"

namespace terp {

/// Writes the frames of the points of a run.
class PointFrameWriter {
 public:
  explicit PointFrameWriter(FrameSeries series) : series_(std::move(series)) {}

  /// Adds a frame, or the next part of one; it is there when its last part is.
  void append(const Frame& frame);

 private:
  FrameSeries series_;
};

}  // namespace terp
