// How it thinks: workers take the next number, solve it, and give the result to one thread, which appends it to the
// store and looks whether the rule is met. Which numbers are in the table follows from the numbers alone
// (TableCounter): workers may finish in any order. A part looks at the rows of all parts from time to time: the rule is
// one of the whole study.

#include "batch/engine.hpp"

#include "io/files/run_folder.hpp"
#include "os/background.hpp"
#include "os/threads.hpp"

#include <chrono>
#include <exception>
#include <numeric>

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;

class Team {
 public:
  Team(const Study& study, const std::string& folder, const EngineOptions& options, const std::atomic<bool>& stop,
      const std::vector<Index>& numbers, std::function<Draw(Index)> draw, Realisations& rows)
      : study_(study),
        folder_(folder),
        options_(options),
        stop_(stop),
        draw_(std::move(draw)),
        rows_(rows),
        store_(study, folder, options.part),
        table_(study)
  {
    for (const Index n : numbers)
      if (options.part.has(study.share_of(n)) && !rows.contains(n)) todo_.push_back(n);
  }

  StudyEnd run()
  {
    table_.take(rows_);
    if (table_.rule_met() || todo_.empty()) return StudyEnd::rule_met;
    use_threads();
    if (stop_.load()) return StudyEnd::stopped;
    return out_of_time_.load() ? StudyEnd::out_of_time : StudyEnd::rule_met;
  }

 private:
  bool may_go_on()
  {
    const Real limit = study_.settings.stop.time;
    if (limit > 0.0 && std::chrono::duration<double>(Clock::now() - options_.begin).count() > limit)
      out_of_time_ = true;
    return !stop_.load() && !enough_.load() && !out_of_time_.load();
  }

  void use_threads()
  {
    const auto n = static_cast<int>(std::min<std::size_t>(todo_.size(), static_cast<std::size_t>(options_.threads)));
    Threads threads(n);
    threads.for_each_chunk(n, [this](Index, int) { work(); });
    background_.finish();
    if (error_) std::rethrow_exception(error_);
  }

  void work()
  {
    try {
      while (may_go_on()) {
        const std::size_t k = next_.fetch_add(1);
        if (k >= todo_.size()) return;
        auto result = realise(study_, todo_[k], draw_(todo_[k]), stop_);
        if (!result) return;
        background_.add([this, r = std::move(*result)] { take(r); });
      }
    } catch (...) {
      if (!failed_.exchange(true)) error_ = std::current_exception();
      enough_ = true;
    }
  }

  void take(const Realisation& newest)
  {
    store_.append(newest);
    rows_.emplace(newest.number, newest);
    if (study_.settings.stop.cov > 0.0) look_at_rule();
    if (options_.show) options_.show(newest, rows_);
  }

  void look_at_rule()
  {
    if (options_.part.n_all > 1) {
      if (std::chrono::duration<double>(Clock::now() - last_look_).count() < options_.look_every) return;
      last_look_ = Clock::now();
      rows_.merge(read_store(study_, folder_).rows);
    }
    table_.take(rows_);
    if (table_.rule_met()) enough_ = true;
  }

  const Study& study_;
  const std::string& folder_;
  const EngineOptions& options_;
  const std::atomic<bool>& stop_;
  std::function<Draw(Index)> draw_;
  Realisations& rows_;
  StoreWriter store_;
  TableCounter table_;
  std::vector<Index> todo_;
  Clock::time_point last_look_ = Clock::now();
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> enough_{false}, out_of_time_{false}, failed_{false};
  std::exception_ptr error_;
  Background background_{64};  // last: its tasks use the rest
};

}  // namespace

StudyEnd run_realisations(const Study& study, const std::string& folder, const EngineOptions& options,
    const std::atomic<bool>& stop, Realisations& rows)
{
  std::vector<Index> numbers(static_cast<std::size_t>(study.n_realisations));
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return solve_realisations(
      study, folder, options, stop, numbers, [&study](Index n) { return draw_realisation(study, n); }, rows);
}

StudyEnd solve_realisations(const Study& study, const std::string& folder, const EngineOptions& options,
    const std::atomic<bool>& stop, const std::vector<Index>& numbers, const std::function<Draw(Index)>& draw,
    Realisations& rows)
{
  return Team(study, folder, options, stop, numbers, draw, rows).run();
}

}  // namespace terp
