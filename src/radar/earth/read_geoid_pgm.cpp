#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "radar/earth/geoid_problem.hpp"
#include "radar/earth/read_geoid.hpp"

namespace sarsim::radar {

namespace {

constexpr std::int64_t max_pgm_nodes = 1'000'000;

// The header of the picture: words between blanks, and comments from # to the end of their line.
class PgmHeader {
 public:
  PgmHeader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  // Reads it; a fault stops the reading.
  std::optional<core::Problem> read() {
    if (word() != "P5")
      return fault("the file is not a PGM of bytes").found(clipped_word()).expected("P5 at its beginning");
    for (std::int64_t* const number : {&width, &height, &levels}) {
      const std::string_view text = word();
      if (problem_) return std::move(problem_);
      const std::optional<std::int64_t> value = core::parse_integer(text);
      if (!value || *value < 1 || *value > max_pgm_nodes)
        return fault("the header of the PGM has no such number")
            .found(clipped_word())
            .expected("the width, the height and 65535, each a number above 0");
      *number = *value;
    }
    if (at_ >= bytes_.size() || !core::is_blank(bytes_[at_]))
      return fault("the PGM ends with its header")
          .expected("one blank or line end, then the pixels")
          .hint("the file may be cut off");
    ++at_;
    return fault_of_content();
  }

  [[nodiscard]] std::string_view pixels() const { return bytes_.substr(at_); }

  std::int64_t width = 0;
  std::int64_t height = 0;
  std::int64_t levels = 0;
  std::optional<double> offset_m;
  std::optional<double> scale_m;

 private:
  [[nodiscard]] core::ProblemBuilder fault(std::string message) const {
    return core::error(std::move(message)).in(name_, line_);
  }
  [[nodiscard]] std::string clipped_word() const { return core::quoted_word(word_); }

  // The next word; empty at the end and where a comment is at fault.
  std::string_view word() {
    while (at_ < bytes_.size() && !problem_ && (core::is_blank(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#')
        take_comment();
      else
        line_ += bytes_[at_++] == '\n' ? 1U : 0U;
    }
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !core::is_blank(bytes_[at_])) ++at_;
    word_ = bytes_.substr(begin, at_ - begin);
    return word_;
  }

  void take_comment() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string_view text = core::trimmed(bytes_.substr(at_ + 1, end - at_ - 1));
    at_ = end;
    const std::size_t gap = std::min(text.find_first_of(" \t"), text.size());
    take_entry(text.substr(0, gap), core::trimmed(text.substr(gap)));
  }

  // One comment "# Key value".
  void take_entry(std::string_view key, std::string_view value) {
    if (key == "Offset") return take_number(key, value, offset_m);
    if (key == "Scale") return take_number(key, value, scale_m);
    if (key == "Origin" && value != "90N 0E")
      problem_ = fault("the picture begins at another place").found(core::quoted_word(value)).expected("Origin 90N 0E");
    if (key == "AREA_OR_POINT" && value != "Point")
      problem_ = fault("the pixels are not points").found(core::quoted_word(value)).expected("AREA_OR_POINT Point");
  }

  void take_number(std::string_view key, std::string_view value, std::optional<double>& number) {
    if (number) {
      problem_ = fault(fmt::format("{} appears twice in the header", key))
                     .found(core::quoted_word(value))
                     .expected("one value");
      return;
    }
    number = core::parse_number(value);
    if (!number)
      problem_ =
          fault(fmt::format("{} is not a number", key)).found(core::quoted_word(value)).expected("a number in m");
  }

  std::optional<core::Problem> fault_of_content() const {
    if (levels != 65535)
      return fault("the pixels of the PGM do not have 16 bits")
          .found(fmt::format("{} levels", levels))
          .expected("65535");
    if (!offset_m || !scale_m)
      return fault("the header does not say how pixels become heights")
          .expected("the comments \"# Offset\" and \"# Scale\", in m")
          .hint("only PGM files of GeographicLib hold geoids, not other pictures");
    if (!(*scale_m > 0.0))
      return fault("Scale is not above 0").found(fmt::format("{}", *scale_m)).expected("m for each level");
    if (width % 2 != 0 || height % 2 != 1 || height < 3)
      return fault("the picture does not cover the Earth from pole to pole")
          .found(fmt::format("{} x {}", width, height))
          .expected("an even width and an odd height of at least 3");
    const std::size_t expected = 2 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (pixels().size() != expected)
      return fault(pixels().size() < expected ? "the PGM file is cut off" : "there is more than pixels in the PGM file")
          .found(fmt::format("{} bytes of pixels", pixels().size()))
          .expected(fmt::format("{} for {} x {}", expected, width, height))
          .hint("get the file again");
    return std::nullopt;
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::string_view word_;
  std::optional<core::Problem> problem_;
};

}  // namespace

std::variant<GeoidGrid, core::Problem> read_geoid_pgm(std::string_view bytes, const std::string& name) {
  PgmHeader header(bytes, name);
  if (std::optional<core::Problem> problem = header.read()) return *std::move(problem);
  const std::string_view pixels = header.pixels();
  GeoidSteps values{header.offset_m.value_or(0.0), header.scale_m.value_or(0.0), {}};
  values.steps.resize(pixels.size() / 2);
  for (std::size_t i = 0; i < values.steps.size(); ++i) {
    const auto high = static_cast<unsigned char>(pixels[2 * i]);
    const auto low = static_cast<unsigned char>(pixels[2 * i + 1]);
    values.steps[i] = static_cast<std::uint16_t>(256U * high + low);
  }
  const GeoidLattice lattice{90.0,
                             -180.0 / static_cast<double>(header.height - 1),
                             0.0,
                             360.0 / static_cast<double>(header.width),
                             static_cast<std::size_t>(header.height),
                             static_cast<std::size_t>(header.width)};
  return geoid::grid_of(name, lattice, std::move(values));
}

}  // namespace sarsim::radar
