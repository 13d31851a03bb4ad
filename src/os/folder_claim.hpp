// A folder that one process holds and others see as held. The system lets go of it when the process ends, however that
// ends, and programs that it starts do not inherit it.
// Not for: words about who has it (io/files/run_folder.hpp).
#pragma once

#include <string>

namespace terp {

enum class ClaimResult {
  taken,
  held_by_another,
  without_locks,  ///< the disk has none, as some network disks: nothing is held, and nothing is known of others
  no_folder,      ///< errno says why it cannot be opened
};

/// Does not wait. claim: for release_claim; -1 unless it is taken.
ClaimResult claim_folder(const std::string& folder, int& claim);
void release_claim(int claim);

/// What claim_folder would give, without taking it from those who look as well.
ClaimResult look_at_claim(const std::string& folder);

}  // namespace terp
