// The table of all keys of the case file as it is written down; keys.hpp is what the rest of the folder asks.
#pragma once

#include "io/case/keys.hpp"

#include <optional>

namespace terp {

/// Words for the values of an enum, in its order.
template <class Enum>
WordField word_field(Enum& value)
{
  return {[&value] { return static_cast<int>(value); }, [&value](int word) { value = static_cast<Enum>(word); }};
}

/// All keys but those of laws, in the order of the case file, without the text of their defaults.
std::vector<KeyInfo> key_table();
/// Those of them that belong to a material.
std::vector<KeyInfo> material_keys();
/// Those of [material.NAME.softening].
std::vector<KeyInfo> softening_keys();
/// Those of [method]: of stresses, and of motion.
std::vector<KeyInfo> method_keys();
std::vector<KeyInfo> motion_keys();
/// Those of water (water_keys.cpp).
std::vector<KeyInfo> water_keys();
/// Those of computed water, of one of its situations, and of the soil that it flows through (seepage_keys.cpp).
std::vector<KeyInfo> seepage_keys();
std::vector<KeyInfo> seepage_keys_of_situation(const std::string& section, WaterSituation& (*of)(Case&, std::size_t));
std::vector<KeyInfo> flow_keys_of_material();
KeyInfo level_key();                    ///< of a series of levels (level_keys.cpp)
std::vector<KeyInfo> force_keys();      ///< of [forces] and [initial]
std::vector<KeyInfo> flood_keys();      ///< of [flood]
std::vector<KeyInfo> reference_keys();  ///< of [reference]

/// Gives the other situations of the water what they leave out: that of the start.
void complete_situations(WaterCase& water);
/// Those of [time].
std::vector<KeyInfo> time_keys();
/// Those of [[stage]].
std::vector<KeyInfo> stage_keys();
/// Those of [[load]].
std::vector<KeyInfo> surface_load_keys();

/// How many entries a case has of a list of sections, "body[]", after adding one if `one_more`; none: it is no list.
std::optional<std::size_t> count_entries(Case& c, std::string_view section, bool one_more);

}  // namespace terp
