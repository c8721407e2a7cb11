#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "core/xml/xml.hpp"
#include "raster/sicd/sicd.hpp"

namespace sarsim::raster {

namespace {

using core::append_count;
using core::append_number;
using core::append_text;

pugi::xml_node append(pugi::xml_node parent, const char* name) { return parent.append_child(name); }

void set(pugi::xml_node node, const char* name, long long value) { node.append_attribute(name).set_value(value); }

long long count_of(std::size_t value) { return static_cast<long long>(value); }

void append_vector(pugi::xml_node parent, const char* name, const core::Vec3& value) {
  const pugi::xml_node node = append(parent, name);
  append_number(node, "X", value.x);
  append_number(node, "Y", value.y);
  append_number(node, "Z", value.z);
}

void append_parameter(pugi::xml_node parent, const std::string& name, const std::string& value) {
  append_text(parent, "Parameter", value).append_attribute("name").set_value(name.c_str());
}

void append_polynomial(pugi::xml_node parent, const char* name, const Polynomial& polynomial) {
  const pugi::xml_node node = append(parent, name);
  set(node, "order1", count_of(polynomial.size()) - 1);
  for (std::size_t i = 0; i < polynomial.size(); ++i)
    set(append_number(node, "Coef", polynomial[i]), "exponent1", count_of(i));
}

void append_polynomial(pugi::xml_node parent, const char* name, const Polynomial2& polynomial) {
  const pugi::xml_node node = append(parent, name);
  set(node, "order1", count_of(polynomial.size()) - 1);
  set(node, "order2", count_of(polynomial.front().size()) - 1);
  for (std::size_t i = 0; i < polynomial.size(); ++i)
    for (std::size_t j = 0; j < polynomial[i].size(); ++j) {
      const pugi::xml_node coefficient = append_number(node, "Coef", polynomial[i][j]);
      set(coefficient, "exponent1", count_of(i));
      set(coefficient, "exponent2", count_of(j));
    }
}

void append_collection(pugi::xml_node root, const Sicd& image) {
  const pugi::xml_node node = append(root, "CollectionInfo");
  append_text(node, "CollectorName", image.collector);
  append_text(node, "CoreName", image.name);
  append_text(node, "CollectType", "MONOSTATIC");
  append_text(append(node, "RadarMode"), "ModeType", image.mode);
  append_text(node, "Classification", "UNCLASSIFIED");
  for (const auto& [name, value] : image.parameters) append_parameter(node, name, value);
  append_text(append(root, "ImageCreation"), "Application", image.application);
}

void append_image_data(pugi::xml_node root, const Sicd& image) {
  const pugi::xml_node node = append(root, "ImageData");
  append_text(node, "PixelType", "RE32F_IM32F");
  append_count(node, "NumRows", count_of(image.rows));
  append_count(node, "NumCols", count_of(image.columns));
  append_count(node, "FirstRow", 0);
  append_count(node, "FirstCol", 0);
  const pugi::xml_node full = append(node, "FullImage");
  append_count(full, "NumRows", count_of(image.rows));
  append_count(full, "NumCols", count_of(image.columns));
  const pugi::xml_node reference = append(node, "SCPPixel");
  append_count(reference, "Row", count_of(image.reference_row));
  append_count(reference, "Col", count_of(image.reference_column));
}

void append_place(pugi::xml_node node, const radar::Geodetic& place) {
  append_number(node, "Lat", core::deg_per_rad * place.latitude_rad);
  append_number(node, "Lon", core::deg_per_rad * place.longitude_rad);
}

void append_geodata(pugi::xml_node root, const Sicd& image) {
  const pugi::xml_node node = append(root, "GeoData");
  append_text(node, "EarthModel", "WGS_84");
  const pugi::xml_node reference = append(node, "SCP");
  append_vector(reference, "ECF", image.reference_ecf_m);
  const radar::Geodetic place = radar::geodetic_of(image.reference_ecf_m);
  const pugi::xml_node llh = append(reference, "LLH");
  append_place(llh, place);
  append_number(llh, "HAE", place.height_m);
  const pugi::xml_node corners = append(node, "ImageCorners");
  constexpr const char* names[] = {"1:FRFC", "2:FRLC", "3:LRLC", "4:LRFC"};
  for (std::size_t i = 0; i < image.corners.size(); ++i) {
    pugi::xml_node corner = append(corners, "ICP");
    corner.append_attribute("index").set_value(names[i]);
    append_place(corner, image.corners[i]);
  }
}

void append_direction(pugi::xml_node parent, const char* name, const SicdDirection& direction) {
  const pugi::xml_node node = append(parent, name);
  append_vector(node, "UVectECF", direction.unit_ecf);
  append_number(node, "SS", direction.step_m);
  append_number(node, "ImpRespWid", direction.width_m);
  append_text(node, "Sgn", "-1");
  append_number(node, "ImpRespBW", direction.bandwidth_per_m);
  append_number(node, "KCtr", direction.centre_per_m);
  append_number(node, "DeltaK1", direction.min_per_m);
  append_number(node, "DeltaK2", direction.max_per_m);
  append_polynomial(node, "DeltaKCOAPoly", direction.offset_per_m);
  const pugi::xml_node window = append(node, "WgtType");
  append_text(window, "WindowName", direction.window);
  for (const auto& [parameter, value] : direction.window_parameters) append_parameter(window, parameter, value);
  if (direction.weights.empty()) return;
  const pugi::xml_node weights = append(node, "WgtFunct");
  set(weights, "size", count_of(direction.weights.size()));
  for (std::size_t i = 0; i < direction.weights.size(); ++i)
    set(append_number(weights, "Wgt", direction.weights[i]), "index", count_of(i) + 1);
}

void append_grid(pugi::xml_node root, const Sicd& image) {
  const pugi::xml_node node = append(root, "Grid");
  append_text(node, "ImagePlane", image.ground ? "GROUND" : "SLANT");
  append_text(node, "Type", image.ground ? "PLANE" : "RGZERO");
  append_polynomial(node, "TimeCOAPoly", image.time_s);
  append_direction(node, "Row", image.row);
  append_direction(node, "Col", image.column);
}

void append_timeline(pugi::xml_node root, const Sicd& image) {
  const pugi::xml_node node = append(root, "Timeline");
  append_text(node, "CollectStart", image.start);
  append_number(node, "CollectDuration", image.duration_s);
  if (image.pulses < 2) return;
  const pugi::xml_node pulses = append(node, "IPP");
  set(pulses, "size", 1);
  const pugi::xml_node all = append(pulses, "Set");
  set(all, "index", 1);
  append_number(all, "TStart", 0.0);
  append_number(all, "TEnd", image.duration_s);
  append_count(all, "IPPStart", 0);
  append_count(all, "IPPEnd", count_of(image.pulses) - 1);
  append_polynomial(all, "IPPPoly", Polynomial{0.0, static_cast<double>(image.pulses) / image.duration_s});
}

void append_position(pugi::xml_node root, const Sicd& image) {
  const pugi::xml_node node = append(append(root, "Position"), "ARPPoly");
  append_polynomial(node, "X", image.position_ecf_m[0]);
  append_polynomial(node, "Y", image.position_ecf_m[1]);
  append_polynomial(node, "Z", image.position_ecf_m[2]);
}

void append_waveform(pugi::xml_node parent, const Sicd& image) {
  if (!(image.pulse_width_s > 0.0)) return;
  const pugi::xml_node waveforms = append(parent, "Waveform");
  set(waveforms, "size", 1);
  const pugi::xml_node node = append(waveforms, "WFParameters");
  set(node, "index", 1);
  append_number(node, "TxPulseLength", image.pulse_width_s);
  append_number(node, "TxRFBandwidth", image.highest_hz - image.lowest_hz);
  append_number(node, "TxFreqStart", image.chirp_rate_hz_per_s < 0.0 ? image.highest_hz : image.lowest_hz);
  append_number(node, "TxFMRate", image.chirp_rate_hz_per_s);
  append_text(node, "RcvDemodType", "CHIRP");
  append_number(node, "RcvWindowLength", image.window_s);
  append_number(node, "ADCSampleRate", image.sample_rate_hz);
  append_number(node, "RcvFMRate", 0.0);
}

void append_radar(pugi::xml_node root, const Sicd& image) {
  const pugi::xml_node node = append(root, "RadarCollection");
  const pugi::xml_node band = append(node, "TxFrequency");
  append_number(band, "Min", image.lowest_hz);
  append_number(band, "Max", image.highest_hz);
  append_waveform(node, image);
  append_text(node, "TxPolarization", "UNKNOWN");
  const pugi::xml_node channels = append(node, "RcvChannels");
  set(channels, "size", 1);
  const pugi::xml_node channel = append(channels, "ChanParameters");
  set(channel, "index", 1);
  append_text(channel, "TxRcvPolarization", "UNKNOWN");
  const pugi::xml_node corners = append(append(node, "Area"), "Corner");
  for (std::size_t i = 0; i < image.corners.size(); ++i) {
    const pugi::xml_node corner = append(corners, "ACP");
    set(corner, "index", count_of(i) + 1);
    append_place(corner, image.corners[i]);
    append_number(corner, "HAE", image.corners[i].height_m);
  }
}

void append_formation(pugi::xml_node root, const Sicd& image) {
  const pugi::xml_node node = append(root, "ImageFormation");
  const pugi::xml_node channel = append(node, "RcvChanProc");
  append_count(channel, "NumChanProc", 1);
  append_count(channel, "PRFScaleFactor", 1);
  append_count(channel, "ChanIndex", 1);
  append_text(node, "TxRcvPolarizationProc", "UNKNOWN");
  append_number(node, "TStartProc", 0.0);
  append_number(node, "TEndProc", image.duration_s);
  const pugi::xml_node band = append(node, "TxFrequencyProc");
  append_number(band, "MinProc", image.lowest_hz);
  append_number(band, "MaxProc", image.highest_hz);
  append_text(node, "ImageFormAlgo", image.approach ? "RMA" : "OTHER");
  append_text(node, "STBeamComp", "NO");
  append_text(node, "ImageBeamComp", "NO");
  append_text(node, "AzAutofocus", image.autofocused ? "SV" : "NO");
  append_text(node, "RgAutofocus", "NO");
  const pugi::xml_node processing = append(node, "Processing");
  append_text(processing, "Type", image.processing);
  append_text(processing, "Applied", "true");
}

void append_view(pugi::xml_node root, const SicdView& view) {
  const pugi::xml_node node = append(root, "SCPCOA");
  append_number(node, "SCPTime", view.time_s);
  append_vector(node, "ARPPos", view.position_ecf_m);
  append_vector(node, "ARPVel", view.velocity_ecf_mps);
  append_vector(node, "ARPAcc", view.acceleration_ecf_mps2);
  append_text(node, "SideOfTrack", view.left ? "L" : "R");
  append_number(node, "SlantRange", view.slant_range_m);
  append_number(node, "GroundRange", view.ground_range_m);
  append_number(node, "DopplerConeAng", view.cone_deg);
  append_number(node, "GrazeAng", view.grazing_deg);
  append_number(node, "IncidenceAng", 90.0 - view.grazing_deg);
  append_number(node, "TwistAng", view.twist_deg);
  append_number(node, "SlopeAng", view.slope_deg);
  append_number(node, "AzimAng", view.azimuth_deg);
  append_number(node, "LayoverAng", view.layover_deg);
}

void append_approach(pugi::xml_node root, const SicdClosestApproach& approach) {
  const pugi::xml_node node = append(root, "RMA");
  append_text(node, "RMAlgoType", approach.algorithm);
  append_text(node, "ImageType", "INCA");
  const pugi::xml_node inca = append(node, "INCA");
  append_polynomial(inca, "TimeCAPoly", approach.time_s);
  append_number(inca, "R_CA_SCP", approach.range_m);
  append_number(inca, "FreqZero", approach.carrier_hz);
  append_polynomial(inca, "DRateSFPoly", approach.rate_factor);
  if (approach.centroid_hz.empty()) return;
  append_polynomial(inca, "DopCentroidPoly", approach.centroid_hz);
  append_text(inca, "DopCentroidCOA", "true");
}

double turned_deg(double angle_rad) {
  const double deg = std::fmod(core::deg_per_rad * angle_rad + 360.0, 360.0);
  return deg < 360.0 ? deg : 0.0;
}

double angle_of(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

core::Vec3 unit(const core::Vec3& vector) { return (1.0 / core::norm(vector)) * vector; }

}  // namespace

SicdView sicd_view(double time_s, const std::array<core::Vec3, 3>& state_ecf, const core::Vec3& point_ecf_m) {
  const auto& [position, velocity, acceleration] = state_ecf;
  SicdView view{time_s, position, velocity, acceleration};
  const core::Vec3 sight = point_ecf_m - position;
  const core::Vec3 look = unit(sight);
  const core::Vec3 ahead = unit(velocity);
  view.slant_range_m = core::norm(sight);
  view.ground_range_m = core::norm(point_ecf_m) * angle_of(core::dot(unit(position), unit(point_ecf_m)));
  view.cone_deg = core::deg_per_rad * angle_of(core::dot(ahead, look));
  view.left = core::dot(core::cross(unit(position), ahead), look) > 0.0;
  const radar::Geodetic place = radar::geodetic_of(point_ecf_m);
  const double lat = place.latitude_rad;
  const double lon = place.longitude_rad;
  const core::Vec3 up{std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
  const core::Vec3 east{-std::sin(lon), std::cos(lon), 0.0};
  const core::Vec3 north = core::cross(up, east);
  const core::Vec3 level = unit(-sight + core::dot(sight, up) * up);  // Towards the radar's foot.
  view.grazing_deg = core::deg_per_rad * angle_of(-core::dot(look, level));
  const core::Vec3 normal = (view.left ? 1.0 : -1.0) * unit(core::cross(ahead, look));  // Of the slant plane.
  const double slope = angle_of(core::dot(up, normal));
  view.slope_deg = core::deg_per_rad * slope;
  view.twist_deg = -core::deg_per_rad * std::asin(std::clamp(core::dot(core::cross(up, level), normal), -1.0, 1.0));
  view.azimuth_deg = turned_deg(std::atan2(core::dot(east, level), core::dot(north, level)));
  const core::Vec3 over = up - (1.0 / std::cos(slope)) * normal;
  view.layover_deg = turned_deg(std::atan2(core::dot(east, over), core::dot(north, over)));
  return view;
}

std::string sicd_xml(const Sicd& image) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("SICD");
  root.append_attribute("xmlns").set_value(std::string(sicd_name_space).c_str());
  append_collection(root, image);
  append_image_data(root, image);
  append_geodata(root, image);
  append_grid(root, image);
  append_timeline(root, image);
  append_position(root, image);
  append_radar(root, image);
  append_formation(root, image);
  append_view(root, image.view);
  if (image.approach) append_approach(root, *image.approach);
  return core::xml_text(document);
}

}  // namespace sarsim::raster
