#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "core/xml/xml.hpp"
#include "radar/earth/earth_depth.hpp"
#include "raster/sicd/sicd.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

// An element that is not as it has to be.
struct ElementFailure {
  std::string message;
  std::string found;
  std::string expected;
};

// The element at a path such as "Grid/Row/SS"; null where it is missing. Of two that differ nothing tells which counts.
pugi::xml_node element_at(pugi::xml_node node, std::string_view path) {
  while (!path.empty() && node) {
    const std::size_t slash = path.find('/');
    const std::string_view name = path.substr(0, slash);
    path = slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1);
    const pugi::xml_node parent = node;
    node = parent.find_child([&](const pugi::xml_node& child) { return core::local_name(child) == name; });
    for (pugi::xml_node other = node.next_sibling(); other; other = other.next_sibling())
      if (core::local_name(other) == name && !core::same_content(node, other))
        throw ElementFailure{fmt::format("the XML text has an element {} twice", name), {}, "one"};
  }
  return node;
}

std::string text_at(pugi::xml_node root, std::string_view path) {
  return std::string(core::trimmed(element_at(root, path).child_value()));
}

std::string needed_text(pugi::xml_node root, std::string_view path) {
  const std::string text = text_at(root, path);
  if (text.empty()) throw ElementFailure{fmt::format("the XML text has no element {}", path), {}, {}};
  return text;
}

std::size_t needed_count(pugi::xml_node root, std::string_view path) {
  constexpr std::int64_t most = 1'000'000'000;
  const std::string text = needed_text(root, path);
  const auto value = core::parse_integer(text);
  if (!value || *value < 1 || *value > most)
    throw ElementFailure{fmt::format("the element {} is not a number of pixels", path), core::quoted_word(text),
                         "1 to 10^9"};
  return static_cast<std::size_t>(*value);
}

// A number that may be missing, but that is one where it is there.
double number_at(pugi::xml_node root, std::string_view path, double otherwise) {
  constexpr double most = 1e15;  // Beyond all places and spacings.
  const std::string text = text_at(root, path);
  if (text.empty()) return otherwise;
  const auto value = core::parse_number(text.starts_with('+') ? text.substr(1) : text);
  if (!value || !(std::abs(*value) <= most))
    throw ElementFailure{fmt::format("the element {} is not a number that can be", path), core::quoted_word(text),
                         "a number up to 1e15"};
  return *value;
}

SicdPixel pixel_of(const std::string& word) {
  if (word == "RE32F_IM32F") return SicdPixel::complex_float;
  if (word == "RE16I_IM16I") return SicdPixel::complex_int16;
  if (word == "AMP8I_PHS8I") return SicdPixel::polar_uint8;
  throw ElementFailure{"the element ImageData/PixelType has an unknown value", core::quoted_word(word),
                       "RE32F_IM32F, RE16I_IM16I or AMP8I_PHS8I"};
}

std::vector<float> amplitudes_of(pugi::xml_node root) {
  const pugi::xml_node table = element_at(root, "ImageData/AmpTable");
  if (!table) return {};
  constexpr std::size_t entries = 256;
  std::vector<float> amplitudes(entries, std::nanf(""));
  for (const pugi::xml_node& entry : table.children()) {
    const auto index = core::parse_integer(entry.attribute("index").value());
    const auto value = core::parse_number(core::trimmed(entry.child_value()));
    if (core::local_name(entry) != "Amplitude") continue;
    if (!index || *index < 0 || *index >= static_cast<std::int64_t>(entries) || !value || !(std::abs(*value) < 1e38))
      throw ElementFailure{"an element ImageData/AmpTable/Amplitude is not a number with an index",
                           fmt::format("index {}: {}", core::quoted_word(entry.attribute("index").value()),
                                       core::quoted_word(entry.child_value())),
                           "index 0 to 255"};
    float& amplitude = amplitudes[static_cast<std::size_t>(*index)];
    if (!std::isnan(amplitude))
      throw ElementFailure{"an element ImageData/AmpTable/Amplitude is there twice", fmt::format("index {}", *index),
                           "each index once"};
    amplitude = static_cast<float>(*value);
  }
  for (const float amplitude : amplitudes)
    if (std::isnan(amplitude))
      throw ElementFailure{"the element ImageData/AmpTable has not all 256 amplitudes", {}, {}};
  return amplitudes;
}

// Middle of the spectrum at the reference point: the first coefficient.
double offset_at(pugi::xml_node root, const char* direction) {
  const pugi::xml_node polynomial = element_at(root, fmt::format("Grid/{}/DeltaKCOAPoly", direction));
  for (const pugi::xml_node& coefficient : polynomial.children())
    if (core::local_name(coefficient) == "Coef" && std::strcmp(coefficient.attribute("exponent1").value(), "0") == 0 &&
        std::strcmp(coefficient.attribute("exponent2").value(), "0") == 0)
      return core::parse_number(core::trimmed(coefficient.child_value())).value_or(0.0);
  return 0.0;
}

ImagePlaces places_of(pugi::xml_node root, const char* direction, const char* first, const char* reference,
                      std::string label, double origin_m) {
  const double step_m = number_at(root, fmt::format("Grid/{}/SS", direction), 0.0);
  if (!(step_m > 0.0))
    throw ElementFailure{fmt::format("the element Grid/{}/SS is not above 0", direction),
                         core::quoted_word(text_at(root, fmt::format("Grid/{}/SS", direction))), "metres"};
  const double from = number_at(root, fmt::format("ImageData/{}", first), 0.0) -
                      number_at(root, fmt::format("ImageData/SCPPixel/{}", reference), 0.0);
  return {std::move(label), "m", origin_m + from * step_m, step_m};
}

FocusedPlaces focused_places(pugi::xml_node root) {
  const bool ranges = text_at(root, "Grid/Type") == "RGZERO" && element_at(root, "RMA/INCA/R_CA_SCP");
  FocusedPlaces places;
  places.azimuth = places_of(root, "Row", "FirstRow", "Row", ranges ? "Slant range" : "Row from the reference point",
                             ranges ? number_at(root, "RMA/INCA/R_CA_SCP", 0.0) : 0.0);
  places.range = places_of(root, "Col", "FirstCol", "Col", ranges ? "Azimuth" : "Column from the reference point", 0.0);
  places.azimuth_centre_per_m = offset_at(root, "Row");
  places.range_centre_per_m = offset_at(root, "Col");
  return places;
}

// What people want to know of a file, where it says so.
std::vector<std::pair<std::string, std::string>> facts_of(pugi::xml_node root) {
  constexpr std::array<std::pair<const char*, const char*>, 16> wanted{{
      {"collector", "CollectionInfo/CollectorName"},
      {"core name", "CollectionInfo/CoreName"},
      {"mode", "CollectionInfo/RadarMode/ModeType"},
      {"classification", "CollectionInfo/Classification"},
      {"application", "ImageCreation/Application"},
      {"pixel type", "ImageData/PixelType"},
      {"image plane", "Grid/ImagePlane"},
      {"grid type", "Grid/Type"},
      {"collection start", "Timeline/CollectStart"},
      {"collection duration s", "Timeline/CollectDuration"},
      {"lowest frequency hz", "RadarCollection/TxFrequency/Min"},
      {"highest frequency hz", "RadarCollection/TxFrequency/Max"},
      {"formed by", "ImageFormation/ImageFormAlgo"},
      {"side of track", "SCPCOA/SideOfTrack"},
      {"grazing angle deg", "SCPCOA/GrazeAng"},
      {"reference point m", "GeoData/SCP/ECF"},
  }};
  std::vector<std::pair<std::string, std::string>> facts;
  for (const auto& [name, path] : wanted) {
    std::string text = text_at(root, path);
    if (text.empty() && element_at(root, path).first_child())
      for (const char* axis : {"X", "Y", "Z"})
        text += (text.empty() ? "" : ", ") + text_at(element_at(root, path), axis);
    if (!text.empty()) facts.emplace_back(name, std::move(text));
  }
  for (const pugi::xml_node& parameter : element_at(root, "CollectionInfo").children())
    if (core::local_name(parameter) == "Parameter")
      facts.emplace_back(parameter.attribute("name").value(), parameter.child_value());
  for (const char* const side : {"Lat", "Lon", "HAE"})
    if (std::string text = text_at(root, fmt::format("GeoData/SCP/LLH/{}", side)); !text.empty())
      facts.emplace_back(side == std::string_view("HAE")   ? "reference height m"
                         : side == std::string_view("Lat") ? "reference latitude deg"
                                                           : "reference longitude deg",
                         std::move(text));
  return facts;
}

// Where the image is, if it says so.
void expect_reference_point(pugi::xml_node root) {
  if (!element_at(root, "GeoData/SCP/ECF").first_child()) return;
  const core::Vec3 place_m{number_at(root, "GeoData/SCP/ECF/X", 0.0), number_at(root, "GeoData/SCP/ECF/Y", 0.0),
                           number_at(root, "GeoData/SCP/ECF/Z", 0.0)};
  if (!(core::norm(place_m) <= radar::farthest_place_m))
    throw ElementFailure{"the element GeoData/SCP/ECF is far from the Earth",
                         fmt::format("{:.6g} m from its centre", core::norm(place_m)),
                         fmt::format("up to {:g} m", radar::farthest_place_m)};
  if (const auto depth_m = radar::impossible_depth_m(place_m))
    throw ElementFailure{"the element GeoData/SCP/ECF lies inside the Earth",
                         fmt::format("{:.6g} m below the ellipsoid", *depth_m),
                         fmt::format("Earth-fixed metres, at most {:g} m below it", -radar::deepest_place_m)};
}

void expect_version(pugi::xml_node root) {
  constexpr std::string_view known = "urn:SICD:1.";
  const std::string_view whole = root.name();
  const std::size_t colon = whole.find(':');
  const std::string attribute =
      colon == std::string_view::npos ? "xmlns" : "xmlns:" + std::string(whole.substr(0, colon));
  const std::string_view space = root.attribute(attribute.c_str()).value();
  if (core::local_name(root) != "SICD" || !space.starts_with(known))
    throw ElementFailure{"the XML text is not one of SICD 1",
                         fmt::format("{} in {}", core::quoted_word(whole), core::quoted_word(space)),
                         "SICD in urn:SICD:1.0.0 to 1.5.0"};
}

// The reference point is a pixel of the full image, of which the file may hold a part.
void expect_reference_within(pugi::xml_node root, const SicdDescription& description) {
  const auto check = [&](const char* pixel, const char* first, const char* full, std::size_t held) {
    const double at = number_at(root, fmt::format("ImageData/SCPPixel/{}", pixel), 0.0);
    const double part_end = number_at(root, fmt::format("ImageData/{}", first), 0.0) + static_cast<double>(held);
    const double end = number_at(root, fmt::format("ImageData/FullImage/{}", full), part_end);
    if (at >= 0.0 && at < std::max(end, part_end)) return;
    throw ElementFailure{fmt::format("the reference point (ImageData/SCPPixel/{}) lies outside the image", pixel),
                         fmt::format("{:g}", at), fmt::format("0 to {:g}", std::max(end, part_end) - 1.0)};
  };
  check("Row", "FirstRow", "NumRows", description.rows);
  check("Col", "FirstCol", "NumCols", description.columns);
}

SicdDescription read_root(pugi::xml_node root) {
  expect_version(root);
  SicdDescription description;
  description.pixel = pixel_of(needed_text(root, "ImageData/PixelType"));
  description.rows = needed_count(root, "ImageData/NumRows");
  description.columns = needed_count(root, "ImageData/NumCols");
  if (description.pixel == SicdPixel::polar_uint8) description.amplitudes = amplitudes_of(root);
  expect_reference_within(root, description);
  description.places = focused_places(root);
  expect_reference_point(root);
  description.facts = facts_of(root);
  return description;
}

}  // namespace

std::size_t bytes_of(SicdPixel pixel) {
  switch (pixel) {
    case SicdPixel::complex_int16: return 4;
    case SicdPixel::polar_uint8: return 2;
    case SicdPixel::complex_float: break;
  }
  return 8;
}

std::variant<SicdDescription, core::Problem> read_sicd_xml(std::string_view text, const std::string& file) {
  pugi::xml_document document;
  if (const std::string failure = core::parse_xml(text, document); !failure.empty())
    return file_problem(file, "its XML text cannot be read: " + failure);
  try {
    return read_root(document.document_element());
  } catch (const ElementFailure& failure) {
    return file_problem(file, failure.message, failure.found, failure.expected);
  }
}

}  // namespace sarsim::raster
