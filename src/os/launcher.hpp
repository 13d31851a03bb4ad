// Which of several processes this one is, where a launcher (mpirun, srun) started them together.
// Not for: what they tell each other (line_socket.hpp).
#pragma once

#include <functional>
#include <string>

namespace terp {

struct Launched {
  int rank = 0, size = 1;  ///< 1: alone
  std::string job = {};    ///< tells this launch from others; empty: the launcher does not say
  bool is_alone() const { return size == 1; }
};

/// What the environment says: Open MPI, the process managers of MPICH and Intel MPI, or Slurm's srun. environment: as
/// std::getenv. Alone, if it says nothing, or nothing that makes sense.
Launched find_launch(const std::function<const char*(const char*)>& environment);

}  // namespace terp
