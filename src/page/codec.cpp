// Most changes of neighbours are alike to a step or two. Four of those that are 0, 1 or 2 after folding go into a byte,
// a 3 says that the number stands in a list after them: gzip cannot spend less than a bit on a symbol of its own.
// Differences wrap around at 16 bits, and so does `no_value`.

#include "page/codec.hpp"

#include "io/files/compress.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace terp {
namespace {

constexpr Real largest_code = 65534.0;  // 65535 is no_value
constexpr unsigned listed = 3;          // of two bits: the number stands in the list

/// 0, -1, 1, -2, ... become 0, 1, 2, 3, ...
std::uint16_t fold(std::uint16_t d) { return static_cast<std::uint16_t>(d << 1 ^ (d & 0x8000 ? 0xffff : 0)); }
std::uint16_t unfold(std::uint16_t u) { return static_cast<std::uint16_t>(u >> 1 ^ (u & 1 ? 0xffff : 0)); }

void append_numbers(std::string& bytes, std::span<const std::uint16_t> numbers)
{
  for (const std::uint16_t n : numbers) bytes += static_cast<char>(n & 0xff);
  for (const std::uint16_t n : numbers) bytes += static_cast<char>(n >> 8);
}

Codes read_numbers(std::string_view bytes)
{
  const std::size_t n = bytes.size() / 2;
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
  Codes numbers(n);
  for (std::size_t k = 0; k < n; ++k) numbers[k] = static_cast<std::uint16_t>(byte(k) | byte(n + k) << 8);
  return numbers;
}

std::string encode_by_frame(std::span<const Codes> frames)
{
  const std::size_t n = frames[0].size();
  std::string bytes((frames.size() * n + 3) / 4, '\0');
  Codes list;
  std::size_t k = 0;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    std::uint16_t left = 0;
    for (std::size_t p = 0; p < n; ++p, ++k) {
      const auto change = static_cast<std::uint16_t>(frames[f][p] - (f > 0 ? frames[f - 1][p] : 0));
      const std::uint16_t u = fold(static_cast<std::uint16_t>(change - left));
      left = change;
      const unsigned two_bits = u < listed ? u : listed;
      bytes[k / 4] = static_cast<char>(static_cast<unsigned char>(bytes[k / 4]) | two_bits << 2 * (k % 4));
      if (two_bits == listed) list.push_back(static_cast<std::uint16_t>(u - listed));
    }
  }
  append_numbers(bytes, list);
  return bytes;
}

std::string encode_by_point(std::span<const Codes> frames)
{
  Codes all;
  all.reserve(frames.size() * frames[0].size());
  for (std::size_t p = 0; p < frames[0].size(); ++p)
    for (const Codes& codes : frames) all.push_back(codes[p]);
  std::string bytes;
  append_numbers(bytes, all);
  return bytes;
}

[[noreturn]] void refuse() { throw std::invalid_argument("not the length of these frames"); }

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

std::string encode_frames(std::span<const Codes> frames, Layout layout)
{
  return layout == Layout::by_frame ? encode_by_frame(frames) : encode_by_point(frames);
}

std::vector<Codes> decode_frames(std::string_view bytes, std::size_t n_frames, std::size_t n_points, Layout layout)
{
  std::vector<Codes> frames(n_frames, Codes(n_points));
  const std::size_t packed = layout == Layout::by_frame ? (n_frames * n_points + 3) / 4 : 0;
  if (bytes.size() < packed || (bytes.size() - packed) % 2 != 0) refuse();
  const Codes list = read_numbers(bytes.substr(packed));
  if (layout == Layout::by_point) {
    if (list.size() != n_frames * n_points) refuse();
    for (std::size_t k = 0; k < list.size(); ++k) frames[k % n_frames][k / n_frames] = list[k];
    return frames;
  }
  std::size_t k = 0, next = 0;
  for (std::size_t f = 0; f < n_frames; ++f) {
    std::uint16_t change = 0;
    for (std::size_t p = 0; p < n_points; ++p, ++k) {
      const unsigned two_bits = static_cast<unsigned char>(bytes[k / 4]) >> 2 * (k % 4) & 3u;
      if (two_bits == listed && next == list.size()) refuse();
      const unsigned u = two_bits == listed ? listed + list[next++] : two_bits;
      change = static_cast<std::uint16_t>(change + unfold(static_cast<std::uint16_t>(u)));
      frames[f][p] = static_cast<std::uint16_t>((f > 0 ? frames[f - 1][p] : 0) + change);
    }
  }
  return frames;
}

Packing best_packing(std::span<const Codes> frames)
{
  constexpr std::size_t part = 64, every = 509;  // neighbours stay together; a prime meets no row of cells twice
  const std::size_t n = frames[0].size();
  std::vector<Codes> sample(frames.size());
  for (std::size_t f = 0; f < frames.size(); ++f)
    for (std::size_t p = 0; p < n; ++p)
      if (n < 32 * every || p % every < part) sample[f].push_back(frames[f][p]);
  const double share = n > 0 ? static_cast<double>(sample[0].size()) / static_cast<double>(n) : 1.0;
  const std::size_t by_frame = gzip(encode_frames(sample, Layout::by_frame)).size(),
                    by_point = gzip(encode_frames(sample, Layout::by_point)).size();
  return {by_frame <= by_point ? Layout::by_frame : Layout::by_point,
      static_cast<std::size_t>(static_cast<double>(std::min(by_frame, by_point)) / share)};
}

std::string pack_words(std::string_view bytes)
{
  const std::size_t n = bytes.size() / 4;
  std::string packed(bytes.size(), '\0');
  std::uint32_t before = 0;
  for (std::size_t k = 0; k < n; ++k) {
    std::uint32_t word = 0;
    std::memcpy(&word, &bytes[4 * k], 4);
    for (std::size_t byte = 0; byte < 4; ++byte)
      packed[byte * n + k] = static_cast<char>((word - before) >> 8 * byte & 0xff);
    before = word;
  }
  return packed;
}

std::string unpack_words(std::string_view packed)
{
  const std::size_t n = packed.size() / 4;
  std::string bytes(packed.size(), '\0');
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t byte = 0; byte < 4; ++byte)
      word += std::uint32_t{static_cast<unsigned char>(packed[byte * n + k])} << 8 * byte;
    std::memcpy(&bytes[4 * k], &word, 4);
  }
  return bytes;
}

}  // namespace terp
