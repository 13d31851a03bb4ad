// In a pipe lines stay, so they are few: one per tenth of the run, or per half where it is one of several, and one a
// minute. A search for equilibrium has no known end, so there is no tenth of it: its plain lines come at wall times
// that double, up to a minute.

#include "cli/progress.hpp"

#include "os/terminal.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/chrono.h>

namespace terp {

constexpr double minute = 60.0;  // [s]

std::string readable_duration(double seconds)
{
  if (!(seconds < 60.0 * 60.0 * 24.0 * 1000.0)) return "-";
  if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string now_in_utc()
{
  return fmt::format(
      "{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

void show(std::FILE* to, const std::string& text)
{
  std::fputs(text.c_str(), to);
  std::fflush(to);
}

LiveLine::LiveLine(std::FILE* to) : to_(to), renews_(is_terminal(to)) {}

void LiveLine::show(const std::string& text)
{
  terp::show(to_, renews_ ? "\r\033[K" + text : text + '\n');
  open_ = renews_;
}

void LiveLine::clear()
{
  if (open_) terp::show(to_, "\r\033[K");
  open_ = false;
}

void LiveLine::end()
{
  if (open_) terp::show(to_, "\n");
  open_ = false;
}

ProgressLine::ProgressLine(bool quiet, std::string label, double later_s)
    : quiet_(quiet), label_(std::move(label)), later_s_(later_s), next_tenth_(label_.empty() ? 1 : 5)
{
}

void ProgressLine::progress(const Progress& p)
{
  if (quiet_ || p.n_steps == 0) return;
  if (p.out_of_balance >= 0.0) return show_search(p);
  const double part = static_cast<double>(p.step) / static_cast<double>(p.n_steps);
  std::string line =
      label_ + fmt::format("{:5.1f} %  {}t = {:.3f} of {}{:g} s  step {} of {}  {:.1f} M point-steps/s  ETA {}{}",
                   100.0 * part, p.stage.empty() ? "" : p.stage + ": ", p.time, p.at_most ? "at most " : "", p.end_time,
                   p.step, p.n_steps, p.point_steps_per_s / 1e6, p.at_most ? "at most " : "",
                   readable_duration(p.eta_s));
  if (later_s_ > 0.0) line += fmt::format(", all {}", readable_duration(p.eta_s + later_s_));
  if (!line_.renews() && 10.0 * part < next_tenth_ && p.wall_s < next_line_s_) return;
  line_.show(line);
  next_line_s_ = p.wall_s + minute;
  next_tenth_ = static_cast<int>(10.0 * part) + (label_.empty() ? 1 : 5);
}

std::string search_text(const Progress& p)
{
  constexpr Index enough = 20;  // steps from which a time follows
  const std::string eta =
      p.step < enough ? "" : fmt::format("  ETA {}{}", p.at_most ? "at most " : "", readable_duration(p.eta_s));
  return fmt::format(
      "search for equilibrium: out of balance {:.1e} of the weight, limit {:.1e}{}  step {} of at most {}{}",
      p.out_of_balance, p.limit, p.out_of_balance <= p.limit ? " reached, the soil still moves" : "", p.step, p.n_steps,
      eta);
}

void ProgressLine::show_search(const Progress& p)
{
  if (!line_.renews() && p.wall_s < next_search_s_) return;
  line_.show(label_ + search_text(p));
  next_search_s_ = p.wall_s + std::min(p.wall_s, minute);
}

}  // namespace terp
