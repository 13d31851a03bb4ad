// The results of a study on the disk: text files that only grow, one line with a checksum per realisation, one file per
// part of the study. A line that a kill has cut is left out, and its realisation is made again.
// Format: docs/formats.md.
#pragma once

#include "io/files/files.hpp"
#include "batch/realise.hpp"
#include "batch/store_head.hpp"

#include <map>
#include <string>
#include <vector>

namespace terp {

/// Part `number` of `n_all`, from 1: every n_all-th realisation, for the arrays of batch systems.
struct StudyPart {
  Index number = 1, n_all = 1;
  bool has(Index share) const { return share % n_all == number - 1; }  ///< as Study::share_of()
  std::string name() const;                                            ///< "part_1_of_4"
  std::string file() const;                                            ///< "part_1_of_4.rows"
};

using Realisations = std::map<Index, Realisation>;

/// Who solved a part of what is there.
struct SolvedUnder {
  StoreHead head = {};
  std::optional<Index> first_solved = {};  ///< none: all that is under it failed or was skipped
};

/// What is there of a study.
struct StoredStudy {
  Realisations rows;
  std::vector<SolvedUnder> solvers;  ///< builds and instruction sets, each once
  int n_files = 0;
  int n_broken = 0;  ///< lines that a kill has cut
};

/// Reads all parts in a folder. Throws FileError: a store of another study or another version, or two results of one
/// realisation that differ.
StoredStudy read_store(const Study& study, const std::string& folder);

/// Of the names of files.
bool is_part_of_store(std::string_view name);

/// Grows by one part. Whoever writes must hold the lock of the part.
class StoreWriter {
 public:
  StoreWriter(const Study& study, const std::string& folder, const StudyPart& part);
  void append(const Realisation& realisation);

 private:
  AppendFile file_;
};

/// A line of the store, without the checksum and the end of the line; and back. None: it is no such line.
std::string line_of(const Realisation& realisation);
std::optional<Realisation> realisation_of(std::string_view line, std::size_t n_inputs);

/// Whether this program may go on with a store that another build, or another instruction set, began. Throws FileError
/// where the results of the two would not have the same bits. What is not known is tried: a realisation of the store is
/// solved once more. Returns what to tell the user; empty: nothing.
std::string check_that_bits_agree(
    const Study& study, const std::string& folder, const StoredStudy& stored, const std::atomic<bool>& stop);

/// A warning where parts that ran at one time had instruction sets that give other bits; empty: none had.
std::string why_bits_differ(const StoredStudy& stored);

}  // namespace terp
