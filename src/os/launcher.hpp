// Which of several processes this one is, where a launcher (mpirun, srun) or an array of Slurm started them.
#pragma once

#include <functional>

namespace terp {

struct Launched {
  int rank = 0, size = 1;       ///< 1: alone
  bool shares_machine = false;  ///< of mpirun or srun: others may be on this machine
  bool is_silent = false;       ///< another one prints to the same terminal, and would say the same
};

/// What the environment says: Open MPI, the process managers of MPICH and Intel MPI, Slurm's srun, and tasks of an
/// array of Slurm; where a task of an array is a job of many ranks, all of them. environment: as std::getenv. Alone, if
/// it says nothing, or nothing that makes sense. Throws FileError for an array with gaps, of which a task has no place.
Launched find_launch(const std::function<const char*(const char*)>& environment);

}  // namespace terp
