// A corner leaves by collapse of a segment: one corner x replaces b and c of a-b-c-d, where the area beside the chain
// stays the same. x is rounded to the grid; the area that this loses is a debt, which the next collapse of the chain
// pays. It makes waiting candidates out of date, so each is computed again before it is used. stays_apart looks at all
// chains before each collapse. Places are added, never renumbered, as several chains refer to them.

#include "import/drawing/region_chains.hpp"

#include "math/plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <set>

namespace terp {
namespace {

constexpr int most_balance_rounds = 8;  // one would do but for round-off; from the fifth on with corners added

/// Where chains end, and the limits of the drawing.
void mark_places(ChainMap& map, const std::vector<std::vector<Index>>& neighbours, Real snap)
{
  const Real infinite = std::numeric_limits<Real>::infinity();
  Real left = infinite, right = -infinite, bottom = infinite;
  for (std::size_t k = 0; k < neighbours.size(); ++k)
    if (!neighbours[k].empty()) {
      left = std::min(left, map.places[k][0]);
      right = std::max(right, map.places[k][0]);
      bottom = std::min(bottom, map.places[k][1]);
    }
  map.limits.assign(map.places.size(), 0);
  map.junction.assign(map.places.size(), 0);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    Vec<2>& x = map.places[k];
    if (neighbours[k].empty()) continue;
    if (std::abs(x[0] - left) <= snap) x[0] = left, map.limits[k] |= 1;
    if (std::abs(x[0] - right) <= snap) x[0] = right, map.limits[k] |= 2;
    if (std::abs(x[1] - bottom) <= snap) x[1] = bottom, map.limits[k] |= 4;
  }
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    if (neighbours[k].empty()) continue;
    map.junction[k] = neighbours[k].size() != 2;
    if (map.limits[k] == 0 || map.junction[k]) continue;
    const char both = map.limits[k] & map.limits[neighbours[k][0]] & map.limits[neighbours[k][1]];
    map.junction[k] = both == 0;  // on a straight part of the limit it is no corner
  }
}

Polygon polyline(const ChainMap& map, const Chain& chain)
{
  Polygon line;
  for (const Index k : chain.places) line.push_back(map.places[k]);
  return line;
}

/// Where one corner may stand for b and c so that the area left of a-b-c-d grows by `more`; not finite: nowhere.
Vec<2> area_keeping_corner(Vec<2> a, Vec<2> b, Vec<2> c, Vec<2> d, Real more)
{
  const Real base = distance(a, d);
  const Real nowhere = std::numeric_limits<Real>::quiet_NaN();
  if (base <= 0.0) return {nowhere, nowhere};
  // Twice the signed area of the line closed by d-a; a move to the right of a-d makes the left side larger.
  const Real twice = cross(a, b, c) + cross(a, c, d) + 2.0 * more;
  const Real height = -twice / base;  // of the corner above a-d, to its left
  const Real of_b = cross(a, d, b) / base, of_c = cross(a, d, c) / base;
  const bool same_side = of_b * of_c >= 0.0;
  const bool on_first = same_side ? std::abs(of_b) > std::abs(of_c) : height * of_b > 0.0;
  const Vec<2> from = on_first ? a : d, to = on_first ? b : c;
  const Real rise = on_first ? of_b : of_c;
  if (std::abs(rise) <= 1e-12 * base) return between(b, c, 0.5);  // all on one line
  return between(from, to, height / rise);
}

/// One chain while corners are taken out. Its corners are nodes of a list, numbered as they were drawn. What may be
/// taken out waits in a heap; after each step only the corners about it are looked at again.
class ChainSimplifier {
 public:
  ChainSimplifier(ChainMap& map, Index chain, const ChainLimits& limits, ChainChanges& changes)
      : map_(map), chain_(map.chains[chain]), limits_(limits), changes_(changes), drawn_(polyline(map, chain_))
  {
    for (std::size_t k = 0; k < drawn_.size(); ++k)
      nodes_.push_back({chain_.places[k], k - 1, k + 1, k, k, 0});  // the first has no one before it: never asked for
    n_left_ = nodes_.size();
  }

  void run()
  {
    // A corner that something stands beside may come out after that has gone: once more, until nothing changes.
    for (bool changed = true; changed;) {
      for (std::size_t k = 1; k + 2 < nodes_.size(); ++k)
        if (nodes_[k].next != gone) push(k);
      changed = false;
      while (!heap_.empty()) changed = take_out_best() || changed;
    }
    chain_.places.clear();
    for (std::size_t k = 0; k < nodes_.size(); k = nodes_[k].next) chain_.places.push_back(nodes_[k].place);
  }

 private:
  static constexpr std::size_t gone = std::numeric_limits<std::size_t>::max() - 1;
  struct Node {
    Index place;
    std::size_t before, next;  ///< next: `gone` of a corner that was taken out
    std::size_t first, last;   ///< of the drawn corners that it stands for
    int version;               ///< counts the changes about it: older entries of the heap do not hold
  };
  struct Candidate {
    std::size_t corner;  ///< b of a-b-c-d
    Vec<2> x;
    Real moved;
    int version;

    bool operator<(const Candidate& other) const  // the one that moves least is on top of the heap
    {
      return moved > other.moved || (moved == other.moved && corner > other.corner);
    }
  };

  Vec<2> at(std::size_t k) const { return map_.places[nodes_[k].place]; }

  void push(std::size_t b)
  {
    if (b == 0 || nodes_[b].next >= nodes_.size() || nodes_[nodes_[b].next].next >= nodes_.size()) return;
    if (const Candidate found = candidate(b); std::isfinite(found.moved)) heap_.push(found);
  }

  Candidate candidate(std::size_t b) const
  {
    const std::size_t before = nodes_[b].before, c = nodes_[b].next, next = nodes_[c].next;
    const Vec<2> a = at(before), d = at(next);
    Candidate found{
        b, area_keeping_corner(a, at(b), at(c), d, debt_), std::numeric_limits<Real>::infinity(), nodes_[b].version};
    for (Real& coordinate : found.x) coordinate = std::round(coordinate / limits_.grid) * limits_.grid;
    if (!std::isfinite(found.x[0] + found.x[1])) return found;
    const Polygon path{a, found.x, d};
    Real moved = distance_to(drawn_, nodes_[before].first, nodes_[next].last, found.x);
    for (std::size_t k = nodes_[before].last + 1; k < nodes_[next].first; ++k)
      moved = std::max(moved, distance_to(path, 0, 2, drawn_[k]));
    const Real shortest = std::min({distance(a, at(b)), distance(at(b), at(c)), distance(at(c), d)});
    const bool is_short = shortest < limits_.shortest_edge;
    if (moved <= (is_short ? std::max(limits_.tolerance, limits_.shortest_edge) : limits_.tolerance))
      found.moved = moved;
    return found;
  }

  /// True if the best candidate was taken out; it leaves the heap in any case.
  bool take_out_best()
  {
    const Candidate best = heap_.top();
    heap_.pop();
    if (best.version != nodes_[best.corner].version || n_left_ <= (is_closed() ? 4u : 3u)) return false;
    const Candidate now = candidate(best.corner);  // the debt has changed since
    if (!std::isfinite(now.moved)) return false;
    if (!heap_.empty() && now.moved > heap_.top().moved) {
      heap_.push(now);
      return false;
    }
    if (!stays_apart(now)) return false;
    take_out(now);
    return true;
  }

  bool is_closed() const { return nodes_.front().place == nodes_.back().place; }

  /// The new lines touch nothing else, and nothing lies between them and the old ones.
  bool stays_apart(const Candidate& found) const
  {
    const std::size_t b = found.corner, before = nodes_[b].before, c = nodes_[b].next, next = nodes_[c].next;
    const Vec<2> a = at(before), d = at(next), x = found.x;
    const Polygon swept{a, at(b), at(c), d, x}, path{a, x, d};
    const Real touch = 0.5 * limits_.grid;
    const BoundingBox box = box_around(swept);
    if (distance(a, x) < limits_.grid || distance(d, x) < limits_.grid) return false;
    const auto is_clear_of = [&](Index one, Index other) {
      const Vec<2> p = map_.places[one], q = map_.places[other];
      if (std::min(p[0], q[0]) > box.high[0] + touch || std::max(p[0], q[0]) < box.low[0] - touch ||
          std::min(p[1], q[1]) > box.high[1] + touch || std::max(p[1], q[1]) < box.low[1] - touch)
        return true;
      Vec<2> crossing;
      if (lines_cross(p, q, a, x, crossing) || lines_cross(p, q, x, d, crossing)) return false;
      if (distance_to({p, q}, 0, 1, x) <= touch) return false;
      return std::ranges::all_of(std::array{one, other}, [&](Index end) {
        if (end == nodes_[before].place || end == nodes_[next].place) return true;
        return distance_to(path, 0, 2, map_.places[end]) > touch && !contains(swept, map_.places[end]);
      });
    };
    for (const Chain& chain : map_.chains)
      if (&chain != &chain_)
        for (std::size_t k = 0; k + 1 < chain.places.size(); ++k)
          if (!is_clear_of(chain.places[k], chain.places[k + 1])) return false;
    for (std::size_t k = 0; nodes_[k].next < nodes_.size(); k = nodes_[k].next)
      if (k != before && k != b && k != c && !is_clear_of(nodes_[k].place, nodes_[nodes_[k].next].place)) return false;
    return true;
  }

  void take_out(const Candidate& found)
  {
    const std::size_t b = found.corner, before = nodes_[b].before, c = nodes_[b].next, next = nodes_[c].next;
    const Vec<2> a = at(before), d = at(next);
    debt_ += 0.5 * (cross(a, at(b), at(c)) + cross(a, at(c), d)) - 0.5 * cross(a, found.x, d);
    changes_.largest = std::max(changes_.largest, found.moved);
    ++changes_.removed;
    map_.places.push_back(found.x);
    map_.limits.push_back(0);
    map_.junction.push_back(0);
    nodes_[b].place = static_cast<Index>(map_.places.size()) - 1;
    nodes_[b].last = nodes_[c].last;
    nodes_[b].next = next;
    nodes_[next].before = b;
    nodes_[c].next = gone;
    ++nodes_[c].version;
    --n_left_;
    std::size_t k = before > 0 ? nodes_[before].before : before;  // from here on four have another a, b, c or d
    for (int count = 0; count < 4 && k < nodes_.size(); ++count, k = nodes_[k].next) {
      ++nodes_[k].version;
      push(k);
    }
  }

  ChainMap& map_;
  Chain& chain_;
  const ChainLimits& limits_;
  ChainChanges& changes_;
  const Polygon drawn_;
  std::vector<Node> nodes_;
  std::size_t n_left_ = 0;
  std::priority_queue<Candidate> heap_;
  Real debt_ = 0.0;  ///< area that rounding took from the left side so far [m^2]
};

bool may_become(const ChainMap& map, Index from, Index to)
{
  return (map.limits[from] & ~map.limits[to]) == 0 && (map.limits[from] == 0 || map.limits[from] == map.limits[to]);
}

/// The map with junction `from` at the place of `to`, without the chain between them.
ChainMap merged(const ChainMap& map, Index chain, Index from, Index to)
{
  ChainMap other = map;
  other.chains.erase(other.chains.begin() + chain);
  for (Chain& c : other.chains)
    for (Index& k : c.places)
      if (k == from) k = to;
  return other;
}

bool is_sound(const ChainMap& map)
{
  std::set<std::pair<Index, Index>> known;
  for (const Chain& chain : map.chains)
    for (std::size_t k = 0; k + 1 < chain.places.size(); ++k)
      if (chain.places[k] == chain.places[k + 1] ||
          !known.insert(std::minmax(chain.places[k], chain.places[k + 1])).second)
        return false;
  return lines_are_apart(graph_of(map));
}

/// The same of a map that was sound before places at one end of its lines became `to`: only these lines are new.
bool is_sound_at(const ChainMap& map, Index to)
{
  const PlanarGraph graph = graph_of(map);
  std::set<Index> others;
  for (const GraphEdge& e : graph.edges) {
    if (e.a != to && e.b != to) continue;
    if (e.a == e.b || !others.insert(e.a == to ? e.b : e.a).second) return false;
    for (const GraphEdge& f : graph.edges)
      if (&f != &e && !are_apart(graph.places, e, f)) return false;
  }
  return true;
}

void merge_junctions(ChainMap& map, const ChainLimits& limits, ChainChanges& changes)
{
  bool was_sound = is_sound(map);
  for (Index k = 0; k < static_cast<Index>(map.chains.size()); ++k) {
    const auto& places = map.chains[k].places;
    if (places.size() != 2) continue;
    const Index a = places[0], b = places[1];
    const Real length = distance(map.places[a], map.places[b]);
    if (length >= limits.shortest_edge) continue;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
      if (!may_become(map, from, to)) continue;
      ChainMap other = merged(map, k, from, to);
      if (!(was_sound ? is_sound_at(other, to) : is_sound(other))) continue;
      was_sound = true;
      map = std::move(other);
      ++changes.merged;
      changes.largest = std::max(changes.largest, length);
      --k;
      break;
    }
  }
}

/// Sum of cross products along a chain about a place: twice the area that it adds to its left side.
Real twice_area(const ChainMap& map, const Chain& chain, Vec<2> about)
{
  Real sum = 0.0;
  for (std::size_t k = 0; k + 1 < chain.places.size(); ++k)
    sum += cross(about, map.places[chain.places[k]], map.places[chain.places[k + 1]]);
  return sum;
}

/// The corner of a chain that changes areas most when it moves; 0: none is free.
std::size_t lever(const ChainMap& map, const Chain& chain)
{
  std::size_t best = 0;
  Real longest = 0.0;
  for (std::size_t k = 1; k + 1 < chain.places.size(); ++k) {
    const Real length = distance(map.places[chain.places[k - 1]], map.places[chain.places[k + 1]]);
    if (map.limits[chain.places[k]] != 0 || length <= longest) continue;
    longest = length;
    best = k;
  }
  return best;
}

/// Solves a x = b for a symmetric matrix that is definite or nearly so.
std::vector<Real> solve(std::vector<std::vector<Real>> a, std::vector<Real> b)
{
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = a[i][k] / a[k][k];
      if (factor == 0.0) continue;
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// A chain that has no free corner gets one in its middle, unless it lies on a limit or its regions lack nothing.
void add_levers(ChainMap& map, const std::vector<Real>& missing)
{
  for (Chain& chain : map.chains) {
    const auto lacks = [&](int region) { return region >= 0 && missing[region] != 0.0; };
    const Index a = chain.places.front(), b = chain.places.back();
    if (chain.places.size() != 2 || (map.limits[a] & map.limits[b]) != 0 || (!lacks(chain.left) && !lacks(chain.right)))
      continue;
    map.places.push_back(between(map.places[a], map.places[b], 0.5));
    map.limits.push_back(0);
    map.junction.push_back(0);
    chain.places.insert(chain.places.begin() + 1, static_cast<Index>(map.places.size()) - 1);
  }
}

/// Moves levers by what the areas lack: the smallest sum of squares of moves over their lengths. Area flows between
/// the two regions of a chain by a difference of potentials, as in a network.
void move_levers(ChainMap& map, const std::vector<Real>& missing, Real farthest, ChainChanges& changes)
{
  const std::size_t n = missing.size();
  std::vector<std::vector<Real>> network(n, std::vector<Real>(n, 0.0));
  std::vector<std::size_t> levers;
  std::vector<Real> weights;
  Real sum = 0.0;
  for (const Chain& chain : map.chains) {
    levers.push_back(lever(map, chain));
    const std::size_t k = levers.back();
    weights.push_back(k == 0 ? 0.0 : distance(map.places[chain.places[k - 1]], map.places[chain.places[k + 1]]));
    sum += weights.back();
    for (const int one : {chain.left, chain.right})
      for (const int two : {chain.left, chain.right})
        if (one >= 0 && two >= 0) network[one][two] += one == two ? weights.back() : -weights.back();
  }
  if (sum == 0.0) return;
  for (std::size_t k = 0; k < n; ++k) network[k][k] += 1e-12 * sum;  // regions that no chain joins to the outside
  const std::vector<Real> potential = solve(network, missing);
  for (std::size_t c = 0; c < map.chains.size(); ++c) {
    const Chain& chain = map.chains[c];
    const auto of = [&](int region) { return region < 0 ? 0.0 : potential[region]; };
    if (levers[c] == 0) continue;
    const Real move = 2.0 * (of(chain.left) - of(chain.right));  // times half the length: the area
    if (!(std::abs(move) <= farthest) || move == 0.0) continue;
    const Vec<2> a = map.places[chain.places[levers[c] - 1]], b = map.places[chain.places[levers[c] + 1]];
    Vec<2>& x = map.places[chain.places[levers[c]]];
    x = {x[0] + move * (b[1] - a[1]) / weights[c], x[1] - move * (b[0] - a[0]) / weights[c]};
    changes.area_move = std::max(changes.area_move, std::abs(move));
  }
}

}  // namespace

ChainMap find_chains(const PlanarGraph& graph, const PlanarFaces& faces, const std::vector<int>& region, Real snap)
{
  ChainMap map{graph.places, {}, {}, {}};
  std::vector<std::vector<Index>> neighbours(graph.places.size());
  std::map<std::pair<Index, Index>, std::pair<int, int>> sides;  // regions left and right of a way
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const int left = region[faces.left[k]], right = region[faces.right[k]];
    const auto [a, b, owners] = graph.edges[k];
    if (left == right) continue;
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
    sides[{a, b}] = {left, right};
    sides[{b, a}] = {right, left};
  }
  mark_places(map, neighbours, snap);
  std::set<std::pair<Index, Index>> walked;
  const auto walk = [&](Index a, Index b) {
    if (walked.contains({a, b})) return;
    Chain chain{{a, b}, sides[{a, b}].first, sides[{a, b}].second};
    for (Index from = a, to = b;;) {
      walked.insert({from, to});
      walked.insert({to, from});
      if (map.junction[to] || to == a) break;
      const Index next = neighbours[to][neighbours[to][0] == from ? 1 : 0];
      from = to;
      to = next;
      chain.places.push_back(to);
    }
    std::erase_if(chain.places, [&](Index k) {  // straight parts of limits
      return map.limits[k] != 0 && !map.junction[k] && k != chain.places.front();
    });
    map.chains.push_back(std::move(chain));
  };
  for (const bool at_junction : {true, false})
    for (Index k = 0; k < static_cast<Index>(neighbours.size()); ++k)
      if (static_cast<bool>(map.junction[k]) == at_junction)
        for (const Index other : neighbours[k]) walk(k, other);
  return map;
}

void simplify(ChainMap& map, const ChainLimits& limits, ChainChanges& changes)
{
  merge_junctions(map, limits, changes);
  for (Index k = 0; k < static_cast<Index>(map.chains.size()); ++k) ChainSimplifier(map, k, limits, changes).run();
}

std::vector<Real> region_areas(const ChainMap& map, std::size_t n_regions)
{
  std::vector<Real> areas(n_regions, 0.0);
  if (map.chains.empty()) return areas;
  const Vec<2> about = map.places[map.chains[0].places[0]];
  for (const Chain& chain : map.chains) {
    const Real area = 0.5 * twice_area(map, chain, about);
    if (chain.left >= 0) areas[chain.left] += area;
    if (chain.right >= 0) areas[chain.right] -= area;
  }
  return areas;
}

void balance_areas(ChainMap& map, const std::vector<Real>& areas, Real farthest, ChainChanges& changes)
{
  const Real whole = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (int round = 0; round < most_balance_rounds; ++round) {
    std::vector<Real> missing = region_areas(map, areas.size());
    for (std::size_t k = 0; k < areas.size(); ++k) {
      missing[k] = areas[k] - missing[k];
      if (std::abs(missing[k]) <= 1e-11 * areas[k] + 1e-14 * whole) missing[k] = 0.0;  // round-off
    }
    if (std::ranges::count(missing, 0.0) == std::ssize(missing)) return;
    if (round == most_balance_rounds / 2) add_levers(map, missing);
    move_levers(map, missing, farthest, changes);
  }
}

PlanarGraph graph_of(const ChainMap& map)
{
  PlanarGraph graph{.places = map.places, .edges = {}, .counts = {}};
  for (const Chain& chain : map.chains)
    for (std::size_t k = 0; k + 1 < chain.places.size(); ++k)
      graph.edges.push_back({chain.places[k], chain.places[k + 1], {chain.left, chain.right}});
  return graph;
}

}  // namespace terp
