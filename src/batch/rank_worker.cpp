// The workers of ranks.hpp: each thread has a connection of its own, and solves one realisation at a time.

#include "math/errors.hpp"
#include "io/files/run_folder.hpp"
#include "os/background.hpp"
#include "os/threads.hpp"
#include "batch/rank_words.hpp"
#include "batch/ranks.hpp"
#include "os/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <filesystem>
#include <utility>

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int wait_ms = 200, longest_connect_ms = 2000;
constexpr auto longest_unreachable = std::chrono::seconds(30);

std::optional<RankPlace> read_place(const std::string& file, const Launched& launched)
{
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return std::nullopt;
  try {
    auto place = rank_place_of(read_file(file));
    return place && place->job == launched.job ? place : std::nullopt;
  } catch (const FileError&) {
    return std::nullopt;  // removed in the meantime
  }
}

std::optional<LineSocket> reach(const RankPlace& place)
{
  const bool here = place.machine == machine_name();
  for (const std::string& address : place.addresses) {
    if ((address == place.addresses.back()) != here) continue;  // the last one leads to the machine itself
    if (auto socket = connect_to(address, place.port, longest_connect_ms)) return socket;
  }
  return std::nullopt;
}

/// "17 TAB 1.5 2.5" -> a draw.
std::pair<Index, Draw> draw_of(const Study& study, std::string_view text)
{
  const auto fail = [] { throw FileError("rank 0 asks for what is no realisation\n  It is another program."); };
  Index number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc() || number < 0 || number >= study.n_realisations) fail();
  std::vector<Real> inputs;
  const char* at = result.ptr;
  const char* const end = text.data() + text.size();
  while (at != end && at + 1 != end) {
    const auto next = std::from_chars(at + 1, end, inputs.emplace_back());
    if (next.ec != std::errc()) fail();
    at = next.ptr;
  }
  return {number, draw_again(study, number, inputs)};
}

class RankWorker {
 public:
  RankWorker(const Study& study, const std::string& name, const std::atomic<bool>& stop)
      : study_(study), name_(name), stop_(stop)
  {
  }

  /// False: there is nothing to do, as the study has ended, or `stop`. Throws FileError as work_for_rank_0.
  bool connect(const std::string& file, const Launched& launched, int n, std::chrono::seconds patience)
  {
    auto end = Clock::now() + patience;
    bool is_there = false;
    while (!stop_.load()) {
      const auto place = read_place(file, launched);
      if (place && place->port == 0 && launched.rank > 0) return false;  // rank 0 itself ends its own worker
      while (place && place->port != 0 && static_cast<int>(sockets_.size()) < n) {
        auto socket = reach(*place);
        if (!socket || !socket->send(line_of(RankHello{place->token, name_, head_of(study_)}))) break;
        sockets_.push_back(std::move(*socket));
      }
      if (static_cast<int>(sockets_.size()) == n) return true;
      if (place && place->port != 0 && !std::exchange(is_there, true))
        end = std::min(end, Clock::now() + longest_unreachable);
      if (Clock::now() > end) refuse_to_wait(is_there, patience);
      wait_seconds(1e-3 * wait_ms);
    }
    return false;
  }

  void work(Threads& threads)
  {
    Background watcher(1);
    watcher.add([this] { watch(); });
    threads.for_each_chunk(threads.count(), [this](Index k, int) { serve(sockets_[static_cast<std::size_t>(k)]); });
    done_ = true;
    watcher.finish();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  [[noreturn]] void refuse_to_wait(bool is_there, std::chrono::seconds patience) const
  {
    throw FileError(is_there
                        ? fmt::format("{} does not reach rank 0: it is gone, or the machines may not talk to each "
                                      "other over TCP",
                              name_)
                        : fmt::format("{} finds no rank 0 within {} s\n  All ranks must see the folder of the study, "
                                      "and reach each other over TCP.",
                              name_, patience.count()));
  }

  /// A realisation is given up where the user stops, and where rank 0 is gone, who would take it.
  void watch()
  {
    while (!done_.load()) {
      if (stop_.load() || std::ranges::any_of(sockets_, &LineSocket::other_end_closed)) halt_ = true;
      wait_seconds(1e-3 * wait_ms);
    }
  }

  void serve(LineSocket& rank_0)
  {
    try {
      for (std::string line;;) {
        const auto got = rank_0.receive(line, wait_ms);
        if (got == LineSocket::Got::gone || (got == LineSocket::Got::nothing && halt_.load())) return;
        if (got == LineSocket::Got::nothing) continue;
        if (!answer(rank_0, line)) return;
      }
    } catch (...) {
      if (!failed_.exchange(true)) error_ = std::current_exception();
      halt_ = true;
    }
  }

  /// False: that was the last line.
  bool answer(LineSocket& rank_0, const std::string& line)
  {
    if (line.starts_with(word_refused))
      throw FileError(fmt::format("{} does not take part: {}", name_, line.substr(word_refused.size())));
    if (!line.starts_with(word_solve)) return false;
    const auto [number, draw] = draw_of(study_, std::string_view(line).substr(word_solve.size()));
    const auto result = realise(study_, number, draw, halt_);
    return result && rank_0.send(std::string(word_result) + line_of(*result));
  }

  const Study& study_;
  std::string name_;
  const std::atomic<bool>& stop_;
  std::vector<LineSocket> sockets_;
  std::atomic<bool> halt_{false}, done_{false}, failed_{false};
  std::exception_ptr error_;
};

}  // namespace

void work_for_rank_0(const Study& study, const std::string& lock_folder, const Launched& launched, int threads,
    const std::atomic<bool>& stop, std::chrono::seconds patience)
{
  RankWorker worker(study, fmt::format("rank {} on {}", launched.rank, machine_name()), stop);
  Threads team(threads);  // fewer where the system grants fewer: a connection of each
  if (worker.connect(path_in(lock_folder, rank_file), launched, team.count(), patience)) worker.work(team);
}

}  // namespace terp
