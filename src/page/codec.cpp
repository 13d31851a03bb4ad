// Values change little from frame to frame, so the high bytes of their differences are mostly 0 or 255: apart from the
// low bytes they cost gzip almost nothing. Differences wrap around at 16 bits, and so does `no_value`.

#include "page/codec.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terp {
namespace {

constexpr Real largest_code = 65534.0;  // 65535 is no_value

}  // namespace

Scale make_scale(Real lo, Real hi, Real step) { return {lo, std::max(step, (hi - lo) / largest_code)}; }

std::uint16_t quantise(Real value, const Scale& scale)
{
  if (std::isnan(value)) return no_value;
  return static_cast<std::uint16_t>(std::clamp(std::round((value - scale.lo) / scale.step), 0.0, largest_code));
}

Codes quantise(std::span<const Real> values, const Scale& scale)
{
  Codes codes(values.size());
  std::transform(values.begin(), values.end(), codes.begin(), [&](Real v) { return quantise(v, scale); });
  return codes;
}

void coarsen(Codes& codes, int factor)
{
  for (std::uint16_t& q : codes)
    if (q != no_value) q = static_cast<std::uint16_t>((q + factor / 2) / factor);
}

std::string encode_frames(std::span<const Codes> frames)
{
  std::string bytes;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const std::size_t n = frames[f].size(), start = bytes.size();
    bytes.resize(start + 2 * n);
    for (std::size_t p = 0; p < n; ++p) {
      const auto d = static_cast<std::uint16_t>(frames[f][p] - (f > 0 ? frames[f - 1][p] : 0));
      bytes[start + p] = static_cast<char>(d & 0xff);
      bytes[start + n + p] = static_cast<char>(d >> 8);
    }
  }
  return bytes;
}

std::vector<Codes> decode_frames(std::string_view bytes, std::size_t n_points)
{
  if (n_points == 0 || bytes.size() % (2 * n_points) != 0) throw std::invalid_argument("not a whole number of frames");
  std::vector<Codes> frames;
  for (std::size_t start = 0; start < bytes.size(); start += 2 * n_points) {
    Codes codes(n_points);
    for (std::size_t p = 0; p < n_points; ++p) {
      const auto low = static_cast<unsigned char>(bytes[start + p]),
                 high = static_cast<unsigned char>(bytes[start + n_points + p]);
      codes[p] = static_cast<std::uint16_t>((frames.empty() ? 0 : frames.back()[p]) + low + 256 * high);
    }
    frames.push_back(std::move(codes));
  }
  return frames;
}

}  // namespace terp
