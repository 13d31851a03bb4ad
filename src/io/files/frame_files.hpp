// The folder frames/ of a run: one static VTKHDF file per frame, and indices of them that ParaView opens
// (docs/formats.md, decision 0040). A file is written under a temporary name and renamed, so that a reader never sees
// half a frame, and never changes afterwards.
// Not for: which points, cells and fields a frame holds (point_frames, mesh_file).
#pragma once

#include "io/files/files.hpp"
#include "io/files/hdf5_file.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

inline constexpr std::string_view frames_folder = "frames";

/// The frames of the material points, or those of the background mesh.
struct FrameKind {
  std::string_view prefix;  ///< of their names
  std::string_view index;   ///< the file that lists them
};
inline constexpr FrameKind point_frames{"points_", "results.vtkhdf.series"};
inline constexpr FrameKind mesh_frames{"mesh_", "mesh.vtkhdf.series"};

/// "frames/points_00007.vtkhdf".
std::string frame_file(const FrameKind& kind, std::int64_t number);

/// The number in a name like "points_00007.vtkhdf"; -1 for any other.
std::int64_t number_of_frame(const FrameKind& kind, std::string_view file_name);

struct FrameHead {
  std::int64_t number = 0;
  Real time = 0.0;  ///< [s]
  std::int64_t step = 0;
  std::string run;  ///< 16 digits that depend on the case
};
FrameHead read_head(const Hdf5File& file);

/// The number of the last frame that the index of a run folder lists. Throws FileError if the index cannot be read.
std::int64_t last_in_index(const std::string& folder, const FrameKind& kind);

/// The numbers of the frames in a run folder, ascending. Empty if there are none.
std::vector<std::int64_t> list_frames(const std::string& folder, const FrameKind& kind);

struct FrameCheck {
  std::vector<FrameHead> good;
  std::vector<std::string> faults;  ///< a sentence for each frame that is missing or damaged
  std::string stranger;             ///< path of a frame of another run; empty if there is none
};

/// Checks the first n_due frames.
FrameCheck check_frames(const std::string& folder, const FrameKind& kind, std::int64_t n_due, const std::string& run);

/// Removes frame `first` and all later ones.
void remove_frames_from(const std::string& folder, const FrameKind& kind, std::int64_t first);

class FrameSeries {
 public:
  /// Touches nothing. run: goes into each frame; next: number of the first frame that is added; before: those to list
  /// before it.
  FrameSeries(std::string folder, const FrameKind& kind, std::string run, std::int64_t next = 0,
      std::vector<FrameHead> before = {});

  /// Begins the next frame: a file of an unstructured grid with nothing in it but its head. n_reserved: as Hdf5File has
  /// it. What an earlier frame has not ended is dropped.
  Hdf5File& begin(Real time, std::int64_t step, std::int64_t n_reserved);

  Hdf5File& open() { return pending_->file; }

  /// Puts the frame in its place, on the disk, and into the index.
  void end();

  const std::string& run() const { return run_; }

  /// Throws FileError if one of the frames that were written is gone.
  void require_all() const;

  /// Writes the index. Without a frame it is removed.
  void write_index() const;

 private:
  std::string folder_, run_;
  FrameKind kind_;
  std::int64_t next_;
  struct Pending {
    TemporaryFile place;
    Hdf5File file;
  };

  std::vector<FrameHead> frames_;
  FrameHead next_head_;
  std::unique_ptr<Pending> pending_;
};

/// What the VTKHDF files of points and mesh share.
namespace vtkhdf {

inline const std::string root = "/VTKHDF";
inline constexpr Hdf5File::Layout exact{.packed = true}, single{true, Hdf5File::Number::float32},
    whole{true, Hdf5File::Number::int32};

/// Version and type of an unstructured grid, and what the run is: for a file that has nothing in it.
void write_head(Hdf5File& file, const std::string& run);

/// NumberOfPoints, NumberOfCells and NumberOfConnectivityIds.
void write_sizes(Hdf5File& file, std::int64_t n_points, std::int64_t n_cells, std::int64_t n_connectivity);

/// A dataset of n_rows rows; add_row(k, values) appends row k. A part at a time: all of a large mesh at once would be
/// the most memory that a run ever takes.
template <class T, class F>
void write_rows(Hdf5File& file, const std::string& name, std::vector<std::int64_t> shape,
    const Hdf5File::Layout& layout, F&& add_row)
{
  constexpr std::int64_t n_at_once = 1 << 18;
  std::vector<T> values;
  for (std::int64_t first = 0; first < shape[0]; first += n_at_once) {
    values.clear();
    for (std::int64_t k = first; k < std::min(first + n_at_once, shape[0]); ++k)
      add_row(static_cast<std::size_t>(k), values);
    file.write<T>(name, shape, values, first, layout);
  }
}

/// Rows first_row ... of a field of n_rows in all. A vector of two components gets a z = 0, as VTK expects.
struct FieldRows {
  std::string name, unit;
  int n_components;
  std::int64_t n_rows, first_row;
};
void write_field(Hdf5File& file, const FieldRows& field, std::span<const Real> values, const Hdf5File::Layout& layout);

}  // namespace vtkhdf

}  // namespace terp
