// Values of all points in all frames as few bytes, 16 bits each, and tables and lines, 32 bits each
// (docs/report_format.md). Not for: which values, and how exact (payload).
#pragma once

#include "math/types.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// One number q of 16 bits per point.
using Codes = std::vector<std::uint16_t>;

inline constexpr std::uint16_t no_value =
    65535;  ///< q of a value that is not a number, or of a point that is not there

/// value = lo + q * step; q of a value is 0 ... 65534.
struct Scale {
  Real lo = 0.0, step = 1.0;

  Real hi() const { return lo + 65535.0 * step; }  ///< value at q = 65535, as the format states it
};

/// The scale with this step, or the least coarser one that holds lo ... hi.
Scale make_scale(Real lo, Real hi, Real step);

/// q of the nearest value that the scale has; `no_value` for NaN.
std::uint16_t quantise(Real value, const Scale& scale);
Codes quantise(std::span<const Real> values, const Scale& scale);

/// The codes on a scale whose steps are `factor` times as long.
void coarsen(Codes& codes, int factor);

/// How the codes of an array lie in its bytes (docs/report_format.md). By frame: what a code changed by, less what that
/// of the point before changed by, which is little where neighbours move alike. By point: the codes themselves, which
/// repeat where the points of a cell have one value.
enum class Layout { by_frame, by_point };

std::string encode_frames(std::span<const Codes> frames, Layout layout);

/// What encode_frames was given. Throws std::invalid_argument if the length is not that of these frames.
std::vector<Codes> decode_frames(std::string_view bytes, std::size_t n_frames, std::size_t n_points, Layout layout);

/// The layout that gzip makes the smallest, and how small, from a part of the points if there are many.
struct Packing {
  Layout layout = Layout::by_frame;
  std::size_t bytes = 0;
};
Packing best_packing(std::span<const Codes> frames);

/// Numbers of 32 bits, given as their bytes, as differences of their bits: all low bytes first, all high ones last.
std::string pack_words(std::string_view bytes);
std::string unpack_words(std::string_view bytes);

}  // namespace terp
