// HDF5 writes through a CommittedFile: a virtual file driver, the way HDF5 lets others do its input and output.
// Not for: new files, which HDF5 writes itself under a temporary name.
#pragma once

#include <cstdint>

namespace terp {

/// Makes files that are opened with these properties (HDF5's identifier of a file access list) change as a whole or not
/// at all.
void use_committed_driver(std::int64_t access);

/// The content up to now is what must not be lost; see CommittedFile::start_changes. file: HDF5's identifier.
void start_changes(std::int64_t file, std::int64_t n_reserved);

/// Closing the file will commit its changes; otherwise they are dropped.
void commit_on_close(std::int64_t file);

}  // namespace terp
