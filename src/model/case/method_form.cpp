#include "model/case/method_form.hpp"

#include "mpm/schemes/scheme.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

template <class T>
std::string text_of(T value)
{
  if constexpr (MethodChoice<T>)
    return std::string(word_of(value));
  else
    return fmt::format("{}", value);
}

}  // namespace

MethodOptions paper_options()
{
  return {.shares = Shares::point,
      .weights = Weights::hybrid,
      .filled_fraction = 0.9,
      .b_bar = true,
      .strain_shares = StrainShares::plain,
      .volume_change = VolumeChange::centre,
      .pressure = Pressure::constant,
      .objective_rate = ObjectiveRate::none,
      .cut_cells = CutCells::mean,
      .remap_contact = RemapContact::unused_strength,
      .relaxation_time = 0.0,
      .flip = 1.0,
      .small_mass = 1e-9};
}

std::vector<std::string> differences_from_paper(const MethodOptions& options, const Scheme& scheme)
{
  MethodOptions paper = paper_options(), used = options;
  std::vector<std::string> of_paper, differences;
  each_option(paper, [&](const char*, auto value) { of_paper.push_back(text_of(value)); });
  std::size_t k = 0;
  each_option(used, [&](const char* name, auto value) {
    const std::string text = text_of(value);
    if (text != of_paper[k++] && looks_at(scheme, name)) differences.push_back(fmt::format("{} = {}", name, text));
  });
  return differences;
}

}  // namespace terp
