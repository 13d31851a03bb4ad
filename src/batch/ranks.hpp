// A study on processes that a launcher started together, on one machine or many (decision 0055): rank 0 hands out
// realisations and writes the store; workers of all ranks solve them. A worker that dies loses what it was solving.
#pragma once

#include "batch/store.hpp"
#include "os/launcher.hpp"
#include "os/line_socket.hpp"

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace terp {

/// What rank 0 has to hand out.
struct RankWork {
  std::function<bool()> goes_on;                ///< false: nothing more is begun
  std::function<bool()> is_stopped;             ///< true: what is under way is given up, too
  std::function<std::optional<Index>()> next;   ///< the next number; none: there are no more
  std::function<std::string(Index)> inputs_of;  ///< those that the number alone does not say, with blanks between
  std::function<void(const Realisation&)> take;
};

/// Of rank 0. Workers find it by a file in the folder of its lock, which only this user can read.
class RankServer {
 public:
  /// lock_folder: of a lock that the caller holds. warn: says what a user must know, one line. Throws FileError,
  /// std::runtime_error.
  RankServer(const Study& study, const std::string& lock_folder, const Launched& launched,
      std::function<void(const std::string&)> warn);
  /// Tells the workers that all is done, those that come too late by the file.
  ~RankServer();
  RankServer(const RankServer&) = delete;
  RankServer& operator=(const RankServer&) = delete;

  /// Returns when all is solved, or nothing more is to be. Throws FileError where a realisation was lost with two
  /// workers, after all others are solved, and where no worker is left.
  void solve(const RankWork& work);
  int n_workers() const { return static_cast<int>(workers_.size()); }
  /// That ever had a worker here.
  int n_ranks() const { return static_cast<int>(names_.size()); }

 private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    std::string name = {};             ///< "rank 3 on node7"
    std::optional<Index> solves = {};  ///< none: it waits
  };

  bool hand_out(const RankWork& work);
  void take(const RankWork& work, const LineServer::Event& event);
  void welcome(const LineServer::Event& event);
  void take_result(const RankWork& work, int who, const std::string& line);
  void lose(int who);
  void refuse_given_up() const;
  void check_that_somebody_works() const;

  const Study& study_;
  std::string file_, token_, job_;
  std::function<void(const std::string&)> warn_;
  LineServer server_;
  std::map<int, Worker> workers_;
  std::set<std::string> names_;
  std::deque<int> idle_;  ///< workers that wait, and some that are gone
  int n_under_way_ = 0;
  std::deque<Index> again_;  ///< lost once
  std::map<Index, int> losses_;
  std::vector<Index> given_up_;
  Clock::time_point last_seen_ = Clock::now();  ///< of any worker
};

/// Of a worker: solves what rank 0 hands out, on `threads` threads, until rank 0 says that all is done, is gone, or
/// `stop`. Throws FileError where rank 0 does not appear within `patience`, or takes no results of this program.
void work_for_rank_0(const Study& study, const std::string& lock_folder, const Launched& launched, int threads,
    const std::atomic<bool>& stop, std::chrono::seconds patience = std::chrono::minutes(10));

}  // namespace terp
