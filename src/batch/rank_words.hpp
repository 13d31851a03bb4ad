// What rank 0 and its workers say to each other: lines of words with tabs between.
#pragma once

#include "batch/store_head.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

inline constexpr const char *rank_folder = "ranks", *rank_file = "ranks/rank_0";  // below that of the lock

/// Contents of the file by which workers find rank 0.
struct RankPlace {
  std::string job = {}, machine = {}, token = {};
  int port = 0;  ///< 0: rank 0 has ended
  std::vector<std::string> addresses = {};
};
std::string text_of(const RankPlace& place);
std::optional<RankPlace> rank_place_of(std::string_view text);

/// How a worker begins.
struct RankHello {
  std::string token = {}, name = {};
  StoreHead head = {};
};
std::string line_of(const RankHello& hello);
/// None: it is no such line.
std::optional<RankHello> rank_hello_of(std::string_view line);

// Rank 0: "solve TAB number TAB inputs", "end", "refused TAB why". A worker: "hello ...", "result TAB line of the
// store".
inline constexpr std::string_view word_solve = "solve\t", word_end = "end", word_refused = "refused\t",
                                  word_result = "result\t";

}  // namespace terp
