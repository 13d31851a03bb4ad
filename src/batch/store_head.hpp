// The first line of a store: which study, and which program solved it, with which instruction set.
#pragma once

#include "batch/study.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace terp {

struct StoreHead {
  std::string version = {}, case_digits = {}, study_digits = {};
  std::string build = {};         ///< id of the program (os/build_id.hpp)
  std::string instructions = {};  ///< instruction set of its kernels
  bool operator==(const StoreHead&) const = default;
};

/// The parts of a text between letters `at`; at least one.
std::vector<std::string> split(std::string_view text, char at);

/// Of this process.
StoreHead head_of(const Study& study);

std::string line_of(const StoreHead& head);
bool is_head(std::string_view line);
/// Throws FileError, which names `path`: no store of a study, or one of another format.
StoreHead read_head(std::string_view line, const std::string& path);

/// Why results under a head are none of the study that `own` is of; empty: they are.
std::string why_of_another_study(const StoreHead& head, const StoreHead& own);

/// What is known of the bits of two heads of one study: equal for equal programs with AVX-512 or AVX2; others with
/// SSE2 (decision 0028); not known of two builds.
enum class SameBits { yes, no, unknown };
SameBits same_bits(const StoreHead& a, const StoreHead& b);

}  // namespace terp
