// Frames of all material points, as ParaView and h5py read them (docs/formats.md).
// Not for: restarting a run (checkpoint); where the files lie (frame_files).
#pragma once

#include "io/files/frame_files.hpp"
#include "run/loop/observer.hpp"

namespace terp {

class PointFrameWriter {
 public:
  /// exact_fields: they have double precision, not single.
  explicit PointFrameWriter(FrameSeries series, bool exact_fields = false)
      : series_(std::move(series)), exact_fields_(exact_fields)
  {
  }

  /// The frame is there when its last part is.
  void append(const Frame& frame);

  const FrameSeries& frames() const { return series_; }

 private:
  FrameSeries series_;
  bool exact_fields_;
};

}  // namespace terp
