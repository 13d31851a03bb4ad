// How it thinks: one thread of rank 0 waits for lines of its workers, and answers each with the next number. It solves
// nothing itself, so that no answer waits. Who dies closes its connection, and its number goes to another worker.

#include "batch/ranks.hpp"

#include "math/errors.hpp"
#include "io/case/printable.hpp"
#include "io/files/run_folder.hpp"
#include "batch/rank_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <random>

namespace terp {
namespace {

constexpr int most_losses = 2;  // of one realisation: a soil that ends its process must not end all of them
constexpr int longest_wait_ms = 200;
constexpr auto longest_alone = std::chrono::seconds(60);

/// 128 bits that nobody guesses: other users of the machine may reach the port.
std::string make_token()
{
  std::random_device device;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", device(), device(), device(), device());
}

/// Its files are not for others, not even while they are written.
void make_private_folder(const std::string& folder)
{
  make_folder(folder);
  std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
}

}  // namespace

RankServer::RankServer(const Study& study, const std::string& lock_folder, const Launched& launched,
    std::function<void(const std::string&)> warn)
    : study_(study),
      file_(path_in(lock_folder, rank_file)),
      token_(make_token()),
      job_(launched.job),
      warn_(std::move(warn))
{
  make_private_folder(path_in(lock_folder, rank_folder));
  write_file_atomically(file_, text_of(RankPlace{.job = launched.job,
                                   .machine = machine_name(),
                                   .token = token_,
                                   .port = server_.port(),
                                   .addresses = own_addresses()}));
}

RankServer::~RankServer()
{
  for (const auto& [who, worker] : workers_) server_.send(who, word_end);
  std::error_code none;
  std::filesystem::remove(file_, none);
  if (job_.empty()) return;  // it could be taken for a word of the next launch
  try {
    write_file_atomically(file_, text_of(RankPlace{.job = job_, .machine = machine_name(), .addresses = {"-"}}));
  } catch (const FileError&) {  // they wait in vain, and end
  }
}

void RankServer::solve(const RankWork& work)
{
  given_up_.clear(), again_.clear();
  while (!work.is_stopped()) {
    const bool has_more = hand_out(work);
    if (!has_more && n_under_way_ == 0) break;
    for (const LineServer::Event& event : server_.wait(longest_wait_ms)) take(work, event);
    check_that_somebody_works();
  }
  refuse_given_up();
}

void RankServer::refuse_given_up() const
{
  if (given_up_.empty()) return;
  throw FileError(
      fmt::format("realisation {}: {} processes that solved it were lost\n  What else is solved is kept. See what it "
                  "does to a process: terp study run STUDY.toml --keep {}",
          fmt::join(given_up_, ", "), most_losses, given_up_.front()));
}

/// False: there is nothing more to hand out.
bool RankServer::hand_out(const RankWork& work)
{
  while (!idle_.empty()) {
    const auto place = workers_.find(idle_.front());
    if (place != workers_.end()) {
      if (!work.goes_on()) return false;
      const std::optional<Index> number = again_.empty() ? work.next() : again_.front();
      if (!number) return false;
      if (!again_.empty()) again_.pop_front();
      place->second.solves = number;
      ++n_under_way_;
      server_.send(place->first, fmt::format("{}{}\t{}", word_solve, *number, work.inputs_of(*number)));  // lost: heard
    }
    idle_.pop_front();
  }
  return work.goes_on();
}

void RankServer::take(const RankWork& work, const LineServer::Event& event)
{
  last_seen_ = Clock::now();
  if (event.got == LineSocket::Got::gone)
    lose(event.who);
  else if (!workers_.contains(event.who))
    welcome(event);
  else
    take_result(work, event.who, event.line);
}

void RankServer::welcome(const LineServer::Event& event)
{
  const auto refuse = [&](const std::string& why) {
    server_.send(event.who, std::string(word_refused) + why);
    server_.close(event.who);
  };
  const auto hello = rank_hello_of(event.line);
  if (!hello || hello->token != token_) return refuse("this is another study");
  const StoreHead own = head_of(study_);
  std::string why = why_of_another_study(hello->head, own);
  if (why.empty() && same_bits(hello->head, own) != SameBits::yes)
    why = fmt::format("it is build {} of terp with {}, rank 0 is build {} with {}, and bits may differ",
        hello->head.build, hello->head.instructions, own.build, own.instructions);
  if (!why.empty()) {
    warn_(fmt::format("{} does not take part: {}", printable(hello->name), printable(why)));
    return refuse(why);
  }
  workers_.emplace(event.who, Worker{.name = printable(hello->name)});
  names_.insert(hello->name);
  idle_.push_back(event.who);
}

void RankServer::take_result(const RankWork& work, int who, const std::string& line)
{
  Worker& worker = workers_.at(who);
  std::optional<Realisation> row;
  if (line.starts_with(word_result))
    row = realisation_of(std::string_view(line).substr(word_result.size()), study_.input_names().size());
  if (!row || worker.solves != row->number) {
    server_.close(who);
    return lose(who);
  }
  losses_.erase(row->number);
  worker.solves.reset();
  --n_under_way_;
  idle_.push_back(who);
  work.take(*row);
}

void RankServer::lose(int who)
{
  const auto place = workers_.find(who);
  if (place == workers_.end()) return;
  const Worker worker = place->second;
  workers_.erase(place);
  if (!worker.solves) return warn_(fmt::format("{} is lost", worker.name));
  --n_under_way_;
  const Index number = *worker.solves;
  const bool goes_again = ++losses_[number] < most_losses;
  if (goes_again)
    again_.push_back(number);
  else
    given_up_.push_back(number);
  warn_(fmt::format("{} is lost; realisation {} {}", worker.name, number,
      goes_again ? "goes to another worker" : "is given up, as it was lost before"));
}

void RankServer::check_that_somebody_works() const
{
  if (!workers_.empty() || Clock::now() - last_seen_ < longest_alone) return;
  refuse_given_up();
  throw FileError(
      "all ranks are lost, or none of them reaches rank 0\n  What is solved is kept. Go on with the same command. "
      "Where no rank ever\n  worked, see that the machines may talk to each other over TCP.");
}

}  // namespace terp
