#include "engine/assets/hdr.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace fulcrum {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// What cannot be read: thrown here and caught in decode_hdr().
struct HdrFault {
  std::string clause;
};

[[noreturn]] void damaged_hdr(const char* why) {
  throw HdrFault{std::string("it is damaged (") + why + "); export it again"};
}

struct HdrHeader {
  std::uint32_t width = 0, height = 0;
  std::array<float, 3> exposure{1, 1, 1};  // that red, green and blue have been multiplied by
};

class HdrReader {
public:
  explicit HdrReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  HdrHeader header() {
    if (!line().starts_with("#?"))
      throw HdrFault{
          "it is no Radiance picture: export it as .hdr (RGBE), not as another format of that name"};
    if (bytes_[at_ - 2] == '\r')
      throw HdrFault{
          "its lines end as on Windows: it was copied as text, which spoils its pixels; copy it anew, as it "
          "is"};
    HdrHeader header;
    for (std::string_view text = line(); !text.empty(); text = line()) {
      if (text.starts_with("FORMAT=") && trimmed(text.substr(7)) != "32-bit_rle_rgbe")
        throw HdrFault{
            "its colours are not red, green and blue (RGBE), which is all that is read: export it so"};
      if (text.starts_with("EXPOSURE=")) {
        const float all = numbers<1>(text.substr(9))[0];
        for (float& part : header.exposure) part *= all;
      }
      if (text.starts_with("COLORCORR=")) {
        const auto parts = numbers<3>(text.substr(10));
        for (std::size_t i = 0; i < 3; ++i) header.exposure[i] *= parts[i];
      }
    }
    for (const float part : header.exposure)
      if (!std::isnormal(part)) damaged_hdr("its exposures together are out of all bounds");
    size(line(), header);
    return header;
  }

  // One row of as many pixels as `row` has.
  void read(std::vector<Rgbe>& row) {
    const auto first = take<4>();
    const std::size_t said = std::size_t{first[2]} << 8U | first[3];
    const bool in_runs = first[0] == 2 && first[1] == 2 && first[2] < 128 && row.size() >= 8;
    if (!in_runs) return read_flat(first, row);
    if (said != row.size()) damaged_hdr("a row has another length");
    for (std::size_t channel = 0; channel < 4; ++channel) read_runs(channel, row);
  }

private:
  template <std::size_t n>
  std::array<std::uint8_t, n> take() {
    if (bytes_.size() - at_ < n) damaged_hdr("it ends too early");
    std::array<std::uint8_t, n> taken;
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), n, taken.begin());
    at_ += n;
    return taken;
  }

  std::string_view line() {
    const std::string_view rest(reinterpret_cast<const char*>(bytes_.data()) + at_, bytes_.size() - at_);
    const std::size_t end = rest.find('\n');
    if (end == rest.npos) damaged_hdr("its header does not end");
    at_ += end + 1;
    return rest.substr(0, end);
  }

  static std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t";
    text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
    return text.substr(0, text.find_last_not_of(kBlank) + 1);
  }

  // Of an exposure: more than 0 each.
  template <std::size_t n>
  static std::array<float, n> numbers(std::string_view text) {
    std::array<float, n> values{};
    for (float& value : values) {
      text = trimmed(text);
      if (text.starts_with('+')) text.remove_prefix(1);
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || !std::isfinite(value) || value <= 0.0F)
        damaged_hdr("its exposure is no number above 0");
      text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return values;
  }

  // "-Y 512 +X 1024": rows from the top, of pixels from the left.
  static void size(std::string_view text, HdrHeader& header) {
    const auto number = [&text](std::string_view before, std::uint32_t& value) {
      if (!text.starts_with(before)) return false;
      const auto [end, error] =
          std::from_chars(text.data() + before.size(), text.data() + text.size(), value);
      text.remove_prefix(static_cast<std::size_t>(end - text.data()));
      return error == std::errc();
    };
    if (!text.starts_with("-Y ") || text.find(" +X ") == text.npos)
      throw HdrFault{"its rows do not go from the top, or its pixels not from the left: export it again"};
    if (!number("-Y ", header.height) || !number(" +X ", header.width) || !text.empty())
      damaged_hdr("its size cannot be read");
    const std::string is =
        "it is " + std::to_string(header.width) + " x " + std::to_string(header.height) + " pixels";
    if (header.width == 0 || header.height == 0) damaged_hdr("it has no pixels");
    if (header.width > kWidestHdr || header.height > kWidestHdr)
      throw HdrFault{is + ": make it smaller, at most " + std::to_string(kWidestHdr) + " x " +
                     std::to_string(kWidestHdr / 2)};
    if (header.width != 2 * header.height)
      throw HdrFault{is +
                     ", and a picture of all around is twice as wide as high: export it as equirectangular"};
  }

  // Each channel by itself: a count above 128 and one value for all, or a count and as many values.
  void read_runs(std::size_t channel, std::vector<Rgbe>& row) {
    for (std::size_t x = 0; x < row.size();) {
      const std::size_t code = take<1>()[0];
      const std::size_t count = code > 128 ? code - 128 : code;
      if (count == 0 || count > row.size() - x) damaged_hdr("a run is longer than its row");
      if (code > 128) {
        const std::uint8_t value = take<1>()[0];
        for (std::size_t i = 0; i < count; ++i) row[x++][channel] = value;
      } else {
        for (std::size_t i = 0; i < count; ++i) row[x++][channel] = take<1>()[0];
      }
    }
  }

  // Pixel by pixel; one of (1, 1, 1, n) stands for n more of the last, and one after it for 256 times as
  // many.
  void read_flat(Rgbe pixel, std::vector<Rgbe>& row) {
    unsigned shift = 0;
    for (std::size_t x = 0;;) {
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const std::size_t count = shift < 16 ? std::size_t{pixel[3]} << shift : row.size();
        if (x == 0 || count > row.size() - x) damaged_hdr("a run is longer than its row");
        std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
        x += count;
        shift += 8;
      } else {
        row[x++] = pixel;
        shift = 0;
      }
      if (x == row.size()) return;
      pixel = take<4>();
    }
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

std::array<float, 3> radiance_of(const Rgbe& pixel, const std::array<float, 3>& exposure) {
  std::array<float, 3> radiance{};
  for (std::size_t i = 0; i < 3 && pixel[3] != 0; ++i) {
    radiance[i] = std::ldexp(static_cast<float>(pixel[i]), pixel[3] - (128 + 8)) / exposure[i];
    if (!(radiance[i] <= kBrightestHdr))
      throw HdrFault{"it has a pixel brighter than any lamp, above 1e9: export it again, with less exposure"};
  }
  return radiance;
}

HdrPicture read_hdr(std::span<const std::uint8_t> encoded) {
  HdrReader reader(encoded);
  const HdrHeader header = reader.header();
  HdrPicture picture{header.width, header.height, {}};
  std::vector<Rgbe> row(header.width);
  for (std::uint32_t y = 0; y < header.height; ++y) {
    reader.read(row);
    for (const Rgbe& pixel : row) picture.pixels.push_back(radiance_of(pixel, header.exposure));
  }
  return picture;
}

}  // namespace

Result<HdrPicture> decode_hdr(std::span<const std::uint8_t> encoded) {
  try {
    return read_hdr(encoded);
  } catch (HdrFault& fault) {
    return Error{std::move(fault.clause)};
  }
}

}  // namespace fulcrum
