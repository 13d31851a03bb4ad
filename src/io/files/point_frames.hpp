// Frames of all material points, as ParaView and h5py read them (docs/formats.md).
// Not for: restarting a run (checkpoint); where the files lie (frame_files).
#pragma once

#include "io/files/frame_files.hpp"
#include "run/loop/observer.hpp"

namespace terp {

class PointFrameWriter {
 public:
  explicit PointFrameWriter(FrameSeries series) : series_(std::move(series)) {}

  /// The frame is there when its last part is.
  void append(const Frame& frame);

 private:
  FrameSeries series_;
};

}  // namespace terp
