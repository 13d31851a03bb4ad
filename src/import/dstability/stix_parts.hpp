// The members of a .stix file, each read by itself: what stages and calculations name by id.
// Not for: other folders. They see the whole project (project.hpp).
#pragma once

#include "import/dstability/json_cursor.hpp"
#include "import/dstability/project.hpp"

#include <map>
#include <string>
#include <vector>

namespace terp {

/// Things by their id, with the place where each was read.
template <class T>
class StixById {
 public:
  /// A second one of an id is a fault.
  void add(const std::string& id, JsonCursor& from, T thing)
  {
    const auto [entry, is_new] = things_.try_emplace(id, std::move(thing), from.where());
    if (!is_new && !id.empty())
      from.fault("Id", "is there twice", "Got " + id + ", which is also the id of " + entry->second.second + ".");
  }
  const T* find(const std::string& id) const
  {
    const auto found = things_.find(id);
    return found == things_.end() ? nullptr : &found->second.first;
  }
  T* find(const std::string& id) { return const_cast<T*>(std::as_const(*this).find(id)); }
  bool empty() const { return things_.empty(); }

 private:
  std::map<std::string, std::pair<T, std::string>> things_;
};

/// A member of the file.
struct StixMember {
  std::string name;  ///< "geometries/geometry_3.json"
  std::string kind;  ///< "geometries": its folder; of one without, its name without ending: "soils"
  JsonNode content;
};

struct StixParts {
  StixById<std::vector<StixLayer>> geometries;
  StixById<std::map<std::string, std::string>> soil_layers;  ///< layer id -> soil id
  StixById<StixWater> waternets;
  StixById<StixWater> water_meshes;
  StixById<StixStates> states;
  StixById<StixDecorations> decorations;
  StixById<StixLoads> loads;
  StixById<StixReinforcements> reinforcements;
  StixById<StixEmbankment> embankments;
  StixById<StixCalculation> settings;
  StixById<StixResult> results;
  StixById<bool> state_correlations;           ///< known, and of no use here
  std::map<std::string, std::string> colours;  ///< soil id -> "#AARRGGBB"
};

/// The soils of soils.json, in its order.
void read_soils(JsonCursor& file, std::vector<StixSoil>& soils);
/// P and its twin PStochasticParameter.
StixParameter read_parameter(JsonCursor& from, const std::string& key, Real unit);

// One member each; the geometry, the waters, and so on.
void read_geometry(JsonCursor& file, StixParts& parts);
void read_soil_layers(JsonCursor& file, StixParts& parts);
void read_decorations(JsonCursor& file, StixParts& parts);
void read_waternet(JsonCursor& file, StixParts& parts);
void read_water_mesh(JsonCursor& file, StixParts& parts);
void read_waternet_creator(JsonCursor& file, StixParts& parts);
void read_states(JsonCursor& file, StixParts& parts);
void read_state_correlations(JsonCursor& file, StixParts& parts);
void read_loads(JsonCursor& file, StixParts& parts);
void read_reinforcements(JsonCursor& file, StixParts& parts);
void read_settings(JsonCursor& file, StixParts& parts);
void read_colours(JsonCursor& file, StixParts& parts);
/// name: of the member below results/, without its ending.
void read_result(JsonCursor& file, const std::string& name, StixParts& parts);

/// Tells of each key that is missing in members that should have it, once for all of a kind and all entries of a list,
/// with the stages that it is of (expected_keys.cpp). Scenarios, or stages of data model 1, stand in the order in which
/// they are numbered. So a damaged file, or one of another program, is not read as if it said nothing of loads, states
/// or water.
void tell_missing_keys(const std::vector<const StixMember*>& members, StixNotes& notes);

inline constexpr Real pa_per_kpa = 1000.0;  ///< also N per kN

}  // namespace terp
