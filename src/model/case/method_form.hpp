// The options of [method] by name and word: those of the paper, and in what others differ from them.
// Not for: reading them (io/case/method_keys), nor what they do (mpm).
#pragma once

#include "mpm/kernels/method_options.hpp"

#include <array>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

struct Scheme;

/// What the options of [method] are where a case does not give them.
enum class MethodForm { terp, paper };

/// Words of the case file for a choice, in the order of its enum.
constexpr std::array<std::string_view, 2> words_of(MethodForm) { return {"terp", "paper"}; }
constexpr std::array<std::string_view, 3> words_of(Shares) { return {"by_law", "point", "overlap"}; }
constexpr std::array<std::string_view, 2> words_of(Weights) { return {"hybrid", "summed"}; }
constexpr std::array<std::string_view, 2> words_of(StrainShares) { return {"plain", "transposed"}; }
constexpr std::array<std::string_view, 2> words_of(VolumeChange) { return {"centre", "soil"}; }
constexpr std::array<std::string_view, 2> words_of(Pressure) { return {"constant", "balanced"}; }
constexpr std::array<std::string_view, 2> words_of(ObjectiveRate) { return {"none", "jaumann"}; }
constexpr std::array<std::string_view, 2> words_of(CutCells) { return {"mean", "slip"}; }
constexpr std::array<std::string_view, 2> words_of(RemapContact) { return {"unused_strength", "across"}; }

template <class T>
concept MethodChoice = requires(T choice)
{
  words_of(choice);
};

template <MethodChoice T>
constexpr std::string_view word_of(T choice)
{
  return words_of(choice)[static_cast<std::size_t>(choice)];
}

/// Calls f(name, value) for each option, which may change it.
template <class F>
void each_option(MethodOptions& options, F&& f)
{
  f("shares", options.shares), f("weights", options.weights), f("filled_fraction", options.filled_fraction);
  f("b_bar", options.b_bar), f("strain_shares", options.strain_shares), f("volume_change", options.volume_change);
  f("pressure", options.pressure), f("cut_cells", options.cut_cells), f("objective_rate", options.objective_rate);
  f("remap_contact", options.remap_contact), f("relaxation_time", options.relaxation_time), f("flip", options.flip);
  f("small_mass", options.small_mass);
}

/// Of checkpoints up to format 7, and of studies of that time.
inline constexpr std::string_view defaults_before =
    "The defaults of [method] were others then. To have them: as = \"paper\", shares = \"by_law\", cut_cells = "
    "\"slip\".";

/// With which cases/column_collapse repeats the paper, bit by bit (decision 0073). They stay when defaults change.
MethodOptions paper_options();

/// Options that a scheme looks at and that are not those of the paper: "shares = overlap".
std::vector<std::string> differences_from_paper(const MethodOptions& options, const Scheme& scheme);

}  // namespace terp
