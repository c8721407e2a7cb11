#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "core/xml/xml.hpp"
#include "radar/earth/earth_depth.hpp"
#include "raster/cphd/cphd_file.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

using core::local_name;
using core::same_content;
using pugi::xml_node;

xml_node child_of(xml_node parent, std::string_view name) {
  for (xml_node node : parent.children())
    if (node.type() == pugi::node_element && local_name(node) == name) return node;
  return {};
}

std::string_view trimmed_text(xml_node node) { return core::trimmed(node.child_value()); }

// Whether a text is a time such as 2024-02-29T23:59:60.5Z.
bool is_utc(std::string_view text) {
  constexpr std::string_view form = "0000-00-00T00:00:00";
  if (text.size() < form.size()) return false;
  for (std::size_t i = 0; i < form.size(); ++i)
    if (form[i] == '0' ? !core::is_digit(text[i]) : text[i] != form[i]) return false;
  const auto number = [&](std::size_t at, std::size_t digits) {
    return static_cast<unsigned>(core::parse_integer(text.substr(at, digits)).value_or(99));
  };
  const std::chrono::year_month_day day{std::chrono::year(static_cast<int>(number(0, 4))),
                                        std::chrono::month(number(5, 2)), std::chrono::day(number(8, 2))};
  return day.ok() && number(11, 2) < 24 && number(14, 2) < 60 && number(17, 2) <= 60;
}

// Walks through the tree and notes what is missing or malformed.
class XmlReading {
 public:
  XmlReading(xml_node root, std::string file, core::Problems& problems)
      : root_(root), file_(std::move(file)), problems_(problems) {}

  [[nodiscard]] bool failed() const { return failed_; }

  void error(std::string message, std::string found, std::string expected, std::string hint = {}) {
    failed_ = true;
    problems_.push_back(
        file_problem(file_, std::move(message), std::move(found), std::move(expected), std::move(hint)));
  }
  void remark(std::string message, std::string found, std::string expected) {
    problems_.push_back(with_severity(file_problem(file_, std::move(message), std::move(found), std::move(expected)),
                                      core::Severity::warning));
  }

  // An element below another one, by a path such as "Global/SGN"; an empty node where there is none.
  static xml_node find(xml_node node, std::string_view path) {
    while (node && !path.empty()) {
      const std::size_t slash = std::min(path.find('/'), path.size());
      node = child_of(node, path.substr(0, slash));
      path.remove_prefix(std::min(slash + 1, path.size()));
    }
    return node;
  }
  // An element of the root, which has no two of one name.
  xml_node find(std::string_view path) { return once(root_, path); }

  // An element by its path; an error where one on the way is there twice and not the same.
  xml_node once(xml_node node, std::string_view path) {
    while (node && !path.empty()) {
      const std::size_t slash = std::min(path.find('/'), path.size());
      node = child_of(node, path.substr(0, slash));
      expect_once(node);
      path.remove_prefix(std::min(slash + 1, path.size()));
    }
    return node;
  }

  // The text of an element that must be there.
  std::string text(xml_node parent, std::string_view path) {
    const xml_node node = once(parent, path);
    const std::string_view found = trimmed_text(node);
    if (found.empty()) error(fmt::format("the XML has no {}/{}", local_name(parent), path), {}, "a value");
    return std::string(found.substr(0, longest));
  }
  // The text of one that may be missing.
  static std::string text_if(xml_node parent, std::string_view path) {
    return std::string(trimmed_text(find(parent, path)).substr(0, longest));
  }

  double number(xml_node parent, std::string_view path) {
    const std::string found = text(parent, path);
    if (found.empty()) return 0.0;
    std::string_view digits = found;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto value = core::parse_number(digits);
    if (!value || !std::isfinite(*value))
      error(fmt::format("{}/{} is not a number", local_name(parent), path), core::quoted_word(found), "a number");
    return value.value_or(0.0);
  }

  std::uint64_t count(xml_node parent, std::string_view path, std::uint64_t least, std::uint64_t most) {
    const std::string found = text(parent, path);
    if (found.empty()) return least;
    const auto value = core::parse_integer(found.starts_with('+') ? found.substr(1) : found);
    if (value && *value >= 0 && static_cast<std::uint64_t>(*value) >= least &&
        static_cast<std::uint64_t>(*value) <= most)
      return static_cast<std::uint64_t>(*value);
    error(fmt::format("{}/{} is out of range", local_name(parent), path), core::quoted_word(found),
          fmt::format("a whole number from {} to {}", least, most));
    return least;
  }

  core::Vec3 place(xml_node parent, std::string_view path) {
    const xml_node node = once(parent, path);
    if (!node) {
      error(fmt::format("the XML has no {}/{}", local_name(parent), path), {}, "X, Y and Z");
      return {};
    }
    return {number(node, "X"), number(node, "Y"), number(node, "Z")};
  }

  // Of two elements of one name nothing tells which one counts.
  void expect_once(xml_node node) {
    for (xml_node next = node.next_sibling(); next; next = next.next_sibling())
      if (next.type() == pugi::node_element && local_name(next) == local_name(node) && !same_content(node, next))
        return error(fmt::format("the XML has {} twice", local_name(node)),
                     node.first_child() == node.last_child()
                         ? fmt::format("'{}' and '{}'", core::quoted_word(trimmed_text(node)),
                                       core::quoted_word(trimmed_text(next)))
                         : std::string(),
                     "one");
  }

  static bool flag_if(xml_node parent, std::string_view path, bool otherwise) {
    const std::string found = text_if(parent, path);
    if (found.empty()) return otherwise;
    return found == "true" || found == "1";
  }

 private:
  static constexpr std::size_t longest = 4096;

  xml_node root_;
  std::string file_;
  core::Problems& problems_;
  bool failed_ = false;
};

constexpr std::uint64_t most = std::uint64_t{1} << 48U;

void read_collection(XmlReading& xml, CphdDescription& d) {
  const xml_node node = xml.find("CollectionID");
  d.collector = XmlReading::text_if(node, "CollectorName");
  d.illuminator = XmlReading::text_if(node, "IlluminatorName");
  d.core_name = XmlReading::text_if(node, "CoreName");
  d.bistatic = XmlReading::text_if(node, "CollectType") == "BISTATIC";
  d.mode = XmlReading::text_if(node, "RadarMode/ModeType");
  d.classification = XmlReading::text_if(node, "Classification");
  d.release = XmlReading::text_if(node, "ReleaseInfo");
  for (xml_node child : node.children())
    if (local_name(child) == "Parameter")
      d.parameters.emplace_back(child.attribute("name").value(), std::string(trimmed_text(child)));
  const bool known = d.mode == "SPOTLIGHT" || d.mode == "STRIPMAP" || d.mode == "DYNAMIC STRIPMAP";
  if (!known)
    xml.remark("the mode of the radar is not one of the standard; it is taken as it is", core::quoted_word(d.mode),
               "SPOTLIGHT, STRIPMAP or DYNAMIC STRIPMAP");
}

void read_global(XmlReading& xml, CphdDescription& d) {
  const xml_node node = xml.find("Global");
  if (!node) {
    xml.error("the XML has no Global", {}, "an element CPHD with CollectionID, Global and so on");
    return;
  }
  const std::string domain = xml.text(node, "DomainType");
  if (!domain.empty() && domain != "FX" && domain != "TOA")
    xml.error("the domain of the samples is not known", core::quoted_word(domain), "FX or TOA");
  d.domain = domain == "TOA" ? PhaseDomain::toa : PhaseDomain::fx;
  const std::string sign = xml.text(node, "SGN");
  if (!sign.empty() && sign != "-1" && sign != "+1" && sign != "1")
    xml.error("the sign of the phase (SGN) is not known", core::quoted_word(sign), "-1 or +1");
  d.sign = sign == "-1" ? -1 : 1;
  d.start = XmlReading::text_if(node, "Timeline/CollectionStart");
  if (!d.start.empty() && !is_utc(d.start))
    xml.remark("Global/Timeline/CollectionStart is no time", core::quoted_word(d.start),
               "such as 2000-01-01T00:00:00Z");
  if (XmlReading::find(node, "Timeline/TxTime1")) d.tx_time1_s = xml.number(node, "Timeline/TxTime1");
  if (XmlReading::find(node, "Timeline/TxTime2")) d.tx_time2_s = xml.number(node, "Timeline/TxTime2");
  d.fx_min_hz = xml.number(node, "FxBand/FxMin");
  d.fx_max_hz = xml.number(node, "FxBand/FxMax");
  d.toa_min_s = xml.number(node, "TOASwath/TOAMin");
  d.toa_max_s = xml.number(node, "TOASwath/TOAMax");
  if (xml.failed()) return;
  if (XmlReading::find(node, "Timeline/TxTime1") && XmlReading::find(node, "Timeline/TxTime2") &&
      d.tx_time2_s < d.tx_time1_s)
    xml.remark("Global/Timeline ends before it begins",
               fmt::format("TxTime1 {:g} s, TxTime2 {:g} s", d.tx_time1_s, d.tx_time2_s), "TxTime1 up to TxTime2");
  if (!(d.fx_min_hz < d.fx_max_hz))
    xml.error("Global/FxBand is empty", fmt::format("{:g} Hz to {:g} Hz", d.fx_min_hz, d.fx_max_hz),
              "FxMin below FxMax");
  if (!(d.toa_min_s < d.toa_max_s))
    xml.error("Global/TOASwath is empty", fmt::format("{:g} s to {:g} s", d.toa_min_s, d.toa_max_s),
              "TOAMin below TOAMax");
}

// The axes of a surface of constant height are given as changes of latitude and longitude in a metre.
core::Vec3 axis_of_height(XmlReading& xml, xml_node node, std::string_view path, const core::Vec3& origin_m) {
  const radar::Geodetic place = radar::geodetic_of(origin_m);
  const radar::CurvatureRadii radii = radar::curvature_radii(place.latitude_rad);
  const double sin_lat = std::sin(place.latitude_rad), cos_lat = std::cos(place.latitude_rad);
  const double sin_lon = std::sin(place.longitude_rad), cos_lon = std::cos(place.longitude_rad);
  const xml_node axis = XmlReading::find(node, path);
  const double north = xml.number(axis ? axis : node, "Lat") * (radii.meridian_m + place.height_m);
  const double east = xml.number(axis ? axis : node, "Lon") * (radii.prime_vertical_m + place.height_m) * cos_lat;
  return east * core::Vec3{-sin_lon, cos_lon, 0.0} +
         north * core::Vec3{-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat};
}

core::Vec3 unit(const core::Vec3& v) {
  const double length = core::norm(v);
  return length > 0.0 ? (1.0 / length) * v : v;
}

// The origin is said twice; texts of latitudes have some digits less.
void compare_origin(XmlReading& xml, xml_node scene, const core::Vec3& origin_m) {
  constexpr double apart_m = 100.0;
  if (!(core::norm(origin_m) <= radar::farthest_place_m && core::norm(origin_m) > 0.0))
    return xml.error("IARP/ECF is no place", fmt::format("({:g}, {:g}, {:g})", origin_m.x, origin_m.y, origin_m.z),
                     "Earth-fixed metres, up to 4e9");
  if (const auto depth_m = radar::impossible_depth_m(origin_m))
    return xml.error("IARP/ECF lies inside the Earth", fmt::format("{:.6g} m below the ellipsoid", *depth_m),
                     fmt::format("Earth-fixed metres, at most {:g} m below it", -radar::deepest_place_m));
  const xml_node llh = XmlReading::find(scene, "IARP/LLH");
  if (!llh) return;
  const radar::Geodetic place{xml.number(llh, "Lat") * core::rad_per_deg, xml.number(llh, "Lon") * core::rad_per_deg,
                              xml.number(llh, "HAE")};
  if (xml.failed()) return;
  const double distance_m = core::norm(radar::ecef_of(place) - origin_m);
  if (!(distance_m <= apart_m))
    xml.remark("IARP/LLH is not the place of IARP/ECF, which counts", fmt::format("{:.6g} m apart", distance_m),
               fmt::format("at most {:g} m", apart_m));
}

void read_scene(XmlReading& xml, CphdDescription& d) {
  const xml_node node = xml.find("SceneCoordinates");
  if (!node) {
    xml.error("the XML has no SceneCoordinates", {}, "where the image area is");
    return;
  }
  SceneCoordinates& scene = d.scene;
  scene.origin_m = xml.place(node, "IARP/ECF");
  if (!xml.failed()) compare_origin(xml, node, scene.origin_m);
  const xml_node planar = XmlReading::find(node, "ReferenceSurface/Planar");
  const xml_node height = XmlReading::find(node, "ReferenceSurface/HAE");
  if (!planar && !height) {
    xml.error("the reference surface is not known", {}, "ReferenceSurface/Planar or ReferenceSurface/HAE");
    return;
  }
  scene.planar = static_cast<bool>(planar);
  scene.x_axis = unit(planar ? xml.place(planar, "uIAX") : axis_of_height(xml, height, "uIAXLL", scene.origin_m));
  scene.y_axis = unit(planar ? xml.place(planar, "uIAY") : axis_of_height(xml, height, "uIAYLL", scene.origin_m));
  constexpr double square = 1e-3;
  if (!xml.failed() && !(core::norm(core::cross(scene.x_axis, scene.y_axis)) > 1.0 - square))
    xml.error("the axes of the image area are not at right angles", {}, "two axes of length above 0 at right angles");
  const xml_node area = XmlReading::find(node, "ImageArea");
  if (!area) {
    xml.error("the XML has no SceneCoordinates/ImageArea", {}, "X1Y1 and X2Y2");
    return;
  }
  scene.area = {xml.number(area, "X1Y1/X"), xml.number(area, "X1Y1/Y"), xml.number(area, "X2Y2/X"),
                xml.number(area, "X2Y2/Y")};
  if (!xml.failed() && !(scene.area.x1 < scene.area.x2 && scene.area.y1 < scene.area.y2))
    xml.error(
        "the image area is empty",
        fmt::format("x {:g} to {:g} m, y {:g} to {:g} m", scene.area.x1, scene.area.x2, scene.area.y1, scene.area.y2),
        "X1Y1 below X2Y2");
}

void read_data(XmlReading& xml, CphdDescription& d) {
  const xml_node node = xml.find("Data");
  if (!node) {
    xml.error("the XML has no Data", {}, "the sizes of the arrays");
    return;
  }
  const std::string encoding = xml.text(node, "SignalArrayFormat");
  const auto known = std::ranges::find(signal_encodings, std::string_view(encoding), &SignalEncodingName::name);
  if (known != signal_encodings.end())
    d.encoding = known->encoding;
  else if (!encoding.empty())
    xml.error("the format of the samples is not known", core::quoted_word(encoding), "CF8, CI4 or CI2");
  const std::string compressed = XmlReading::text_if(node, "SignalCompressionID");
  if (!compressed.empty())
    xml.error("compressed samples are not read", core::quoted_word(compressed), "no SignalCompressionID");
  constexpr std::uint64_t word = 8;
  constexpr std::uint64_t max_pvp_bytes = 1U << 20U;
  d.pvp_bytes = static_cast<std::size_t>(xml.count(node, "NumBytesPVP", word, max_pvp_bytes));
  std::set<std::string> names;
  for (xml_node child : node.children()) {
    if (local_name(child) != "Channel") continue;
    PhaseChannel channel;
    channel.id = xml.text(child, "Identifier");
    channel.vectors = static_cast<std::size_t>(xml.count(child, "NumVectors", 1, most));
    channel.samples = static_cast<std::size_t>(xml.count(child, "NumSamples", 1, most));
    channel.signal_offset = xml.count(child, "SignalArrayByteOffset", 0, most * 1024);
    channel.pvp_offset = xml.count(child, "PVPArrayByteOffset", 0, most * 1024);
    if (!names.insert(channel.id).second)
      xml.error("two channels have one identifier", core::quoted_word(channel.id), "different ones");
    d.channels.push_back(std::move(channel));
    if (xml.failed()) return;
  }
  if (d.channels.empty()) xml.error("the file has no channel", {}, "at least one Data/Channel");
  if (!XmlReading::find(node, "NumCPHDChannels")) return;
  const std::uint64_t channels = xml.count(node, "NumCPHDChannels", 1, most);
  if (!xml.failed() && channels != d.channels.size())
    xml.error("NumCPHDChannels is not the number of channels", fmt::format("{}", channels),
              fmt::format("{} elements Data/Channel", d.channels.size()));
}

void read_channels(XmlReading& xml, CphdDescription& d) {
  const xml_node node = xml.find("Channel");
  const std::string reference = XmlReading::text_if(node, "RefChId");
  const auto found = std::ranges::find(d.channels, reference, &PhaseChannel::id);
  if (found != d.channels.end()) d.reference_channel = static_cast<std::size_t>(found - d.channels.begin());
  if (found == d.channels.end() && !reference.empty())
    xml.remark(fmt::format("Channel/RefChId is the identifier of no channel; '{}' is taken",
                           core::quoted_word(d.channels.front().id)),
               core::quoted_word(reference), "one of Data/Channel/Identifier");
  for (xml_node child : node.children()) {
    if (local_name(child) != "Parameters") continue;
    const auto channel = std::ranges::find(d.channels, XmlReading::text_if(child, "Identifier"), &PhaseChannel::id);
    if (channel == d.channels.end()) continue;
    channel->reference = static_cast<std::size_t>(xml.count(child, "RefVectorIndex", 0, channel->vectors - 1));
    channel->fx_fixed = XmlReading::flag_if(child, "FXFixed", true);
    channel->toa_fixed = XmlReading::flag_if(child, "TOAFixed", true);
    channel->srp_fixed = XmlReading::flag_if(child, "SRPFixed", true);
    channel->transmitted = XmlReading::text_if(child, "Polarization/TxPol");
    channel->received = XmlReading::text_if(child, "Polarization/RcvPol");
    channel->centre_hz = xml.number(child, "FxC");
    channel->band_hz = xml.number(child, "FxBW");
    channel->toa_s = xml.number(child, "TOASaved");
  }
}

// Whether the numbers of a parameter are those of the standard: 8 bytes each. Blanks and a last semicolon do not count.
void check_format(XmlReading& xml, const PvpField& field, xml_node parameter) {
  std::string format = XmlReading::text_if(parameter, "Format");
  std::erase(format, ' ');
  if (format.ends_with(';')) format.pop_back();
  if (format.empty()) return;
  const std::string_view expected = field.integer != nullptr ? "I8" : field.words == 1 ? "F8" : "X=F8;Y=F8;Z=F8";
  if (format != expected)
    xml.error(fmt::format("the numbers of PVP/{} are not those of the standard (Format)", field.name),
              core::quoted_word(format), std::string(expected));
}

// Whether two parameters are said to be at one place.
void check_overlaps(XmlReading& xml, std::vector<PvpSlot> slots) {
  std::ranges::sort(slots, {}, &PvpSlot::offset);
  constexpr std::size_t word = 8;
  for (std::size_t i = 1; i < slots.size(); ++i)
    if (slots[i].offset < slots[i - 1].offset + word * slots[i - 1].field->words)
      xml.error(fmt::format("PVP/{} and PVP/{} lie at one place", slots[i - 1].field->name, slots[i].field->name),
                fmt::format("word {}", slots[i].offset / word), "an Offset of its own for each");
}

// Where the parameters stand in a vector.
std::vector<PvpSlot> read_slots(XmlReading& xml, const CphdDescription& d) {
  constexpr std::uint64_t word = 8;
  std::vector<PvpSlot> slots;
  const xml_node node = xml.find("PVP");
  for (const PvpField& field : pvp_fields()) {
    const xml_node parameter = child_of(node, field.name);
    if (!parameter) {
      if (!field.optional)
        xml.error(fmt::format("the XML has no PVP/{}", field.name), {}, "its Offset, Size and Format");
      continue;
    }
    xml.expect_once(parameter);
    check_format(xml, field, parameter);
    const std::uint64_t size = xml.count(parameter, "Size", field.words, field.words);
    const std::uint64_t offset = xml.count(parameter, "Offset", 0, d.pvp_bytes / word);
    if (!xml.failed() && word * (offset + size) > d.pvp_bytes)
      xml.error(fmt::format("the parameter {} lies beyond the end of its vector", field.name),
                fmt::format("words {} to {}", offset, offset + size - 1),
                fmt::format("NumBytesPVP, {} bytes", d.pvp_bytes));
    slots.push_back({&field, static_cast<std::size_t>(word * offset)});
  }
  if (!xml.failed()) check_overlaps(xml, slots);
  return slots;
}

}  // namespace

std::optional<std::pair<CphdDescription, std::vector<PvpSlot>>> read_cphd_xml(std::string_view text,
                                                                              const std::string& file,
                                                                              core::Problems& problems) {
  pugi::xml_document document;
  const std::string wrong = core::parse_xml(text, document);
  if (!wrong.empty()) {
    problems.push_back(file_problem(file, "the XML of the file cannot be read: " + wrong));
    return std::nullopt;
  }
  const xml_node root = child_of(document, "CPHD");
  XmlReading xml(root, file, problems);
  if (!root) {
    xml.error("the XML does not describe CPHD", {}, "an element CPHD");
    return std::nullopt;
  }
  CphdDescription d;
  read_collection(xml, d);
  read_global(xml, d);
  read_scene(xml, d);
  read_data(xml, d);
  if (xml.failed()) return std::nullopt;
  read_channels(xml, d);
  std::vector<PvpSlot> slots = read_slots(xml, d);
  if (xml.failed()) return std::nullopt;
  return std::pair{std::move(d), std::move(slots)};
}

}  // namespace sarsim::raster
