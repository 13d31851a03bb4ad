// What all files in the VTKHDF format share: the header, the group of steps, fields with units, cutting steps off.
// Not for: which points, cells and fields a file holds (vtkhdf, mesh_file).
#pragma once

#include "output/hdf5_file.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace terp::vtkhdf {

inline const std::string root = "/VTKHDF";
inline const std::string steps = root + "/Steps";

/// Columns in the file: 0 for scalars (one-dimensional); vectors get a z, as VTK wants them.
int n_columns(int n_components);

/// Rows of two components become rows of three with z = 0.
std::vector<Real> with_z(const std::vector<Real>& values);

/// Version and type, for a file of an unstructured grid, and the run that it is of: digits of its case; empty if not
/// known.
void add_header(Hdf5File& file, const std::string& run);

/// How many points and cells the grid of a file has.
struct GridSize {
  std::int64_t n_points, n_cells;
};

/// Why a file cannot be that of the run with these digits and this grid; empty if it may. One that names no run, of an
/// earlier Terp, may.
std::string why_of_another_run(const Hdf5File& file, const std::string& run, const GridSize& grid);

/// The group of steps with none in it yet; its groups of data offsets are made before.
void add_steps(Hdf5File& file);

/// Names a field's unit and components.
void describe_field(Hdf5File& file, const std::string& table, const std::string& unit, int n_components);

/// A whole number in row `row` of a one-dimensional table.
void write_integer(Hdf5File& file, const std::string& table, std::int64_t row, std::int64_t value);

/// Step k of a grid whose cells are the same in every step. first_point: where its places begin.
void write_step(Hdf5File& file, std::int64_t k, Real time, std::int64_t step, std::int64_t first_point);

/// Whole steps up to the time step `step`.
std::int64_t count_steps(const Hdf5File& file, std::int64_t step);

/// A table that grows by n_rows with every step.
struct StepTable {
  std::string name;
  std::int64_t n_rows;
  std::int64_t n_columns;  ///< 0: one-dimensional
};

/// Drops what came after the time step `step`. Throws FileError and changes nothing if a table is not there, or not as
/// large as the file says.
void cut_steps(Hdf5File& file, std::int64_t step, std::vector<StepTable> tables);

}  // namespace terp::vtkhdf
