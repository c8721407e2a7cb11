#include "core/xml/xml.hpp"
#include "raster/cphd/cphd_description.hpp"
#include "raster/cphd/scene_xml.hpp"

namespace sarsim::raster {

namespace {

using core::append_count;
using core::append_number;
using core::append_text;
using pugi::xml_node;

void put_collection(xml_node root, const CphdDescription& d) {
  xml_node node = root.append_child("CollectionID");
  append_text(node, "CollectorName", d.collector);
  if (d.bistatic) append_text(node, "IlluminatorName", d.illuminator);
  append_text(node, "CoreName", d.core_name);
  append_text(node, "CollectType", d.bistatic ? "BISTATIC" : "MONOSTATIC");
  append_text(node.append_child("RadarMode"), "ModeType", d.mode);
  append_text(node, "Classification", d.classification);
  append_text(node, "ReleaseInfo", d.release);
  for (const auto& [name, value] : d.parameters) put_parameter(node, name, value);
}

void put_global(xml_node root, const CphdDescription& d) {
  xml_node node = root.append_child("Global");
  append_text(node, "DomainType", d.domain == PhaseDomain::fx ? "FX" : "TOA");
  append_text(node, "SGN", d.sign < 0 ? "-1" : "+1");
  xml_node time = node.append_child("Timeline");
  append_text(time, "CollectionStart", d.start);
  if (d.bistatic) append_text(time, "RcvCollectionStart", d.start);
  append_number(time, "TxTime1", d.tx_time1_s);
  append_number(time, "TxTime2", d.tx_time2_s);
  xml_node band = node.append_child("FxBand");
  append_number(band, "FxMin", d.fx_min_hz);
  append_number(band, "FxMax", d.fx_max_hz);
  xml_node swath = node.append_child("TOASwath");
  append_number(swath, "TOAMin", d.toa_min_s);
  append_number(swath, "TOAMax", d.toa_max_s);
}

void put_data(xml_node root, const CphdDescription& d) {
  xml_node node = root.append_child("Data");
  append_text(node, "SignalArrayFormat", std::string(entry_of(d.encoding).name));
  append_count(node, "NumBytesPVP", static_cast<long long>(d.pvp_bytes));
  append_count(node, "NumCPHDChannels", static_cast<long long>(d.channels.size()));
  for (const PhaseChannel& channel : d.channels) {
    xml_node c = node.append_child("Channel");
    append_text(c, "Identifier", channel.id);
    append_count(c, "NumVectors", static_cast<long long>(channel.vectors));
    append_count(c, "NumSamples", static_cast<long long>(channel.samples));
    append_count(c, "SignalArrayByteOffset", static_cast<long long>(channel.signal_offset));
    append_count(c, "PVPArrayByteOffset", static_cast<long long>(channel.pvp_offset));
  }
  append_count(node, "NumSupportArrays", 0);
}

bool all_of_channels(const CphdDescription& d, bool PhaseChannel::*fixed) {
  for (const PhaseChannel& channel : d.channels)
    if (!(channel.*fixed)) return false;
  return true;
}

void put_channels(xml_node root, const CphdDescription& d) {
  xml_node node = root.append_child("Channel");
  append_text(node, "RefChId", d.channels.at(d.reference_channel).id);
  put_flag(node, "FXFixedCPHD", all_of_channels(d, &PhaseChannel::fx_fixed));
  put_flag(node, "TOAFixedCPHD", all_of_channels(d, &PhaseChannel::toa_fixed));
  put_flag(node, "SRPFixedCPHD", all_of_channels(d, &PhaseChannel::srp_fixed));
  for (const PhaseChannel& channel : d.channels) {
    xml_node p = node.append_child("Parameters");
    append_text(p, "Identifier", channel.id);
    append_count(p, "RefVectorIndex", static_cast<long long>(channel.reference));
    put_flag(p, "FXFixed", channel.fx_fixed);
    put_flag(p, "TOAFixed", channel.toa_fixed);
    put_flag(p, "SRPFixed", channel.srp_fixed);
    put_flag(p, "SignalNormal", true);
    xml_node polarisation = p.append_child("Polarization");
    append_text(polarisation, "TxPol", channel.transmitted);
    append_text(polarisation, "RcvPol", channel.received);
    append_number(p, "FxC", channel.centre_hz);
    append_number(p, "FxBW", channel.band_hz);
    append_number(p, "TOASaved", channel.toa_s);
    xml_node times = p.append_child("DwellTimes");
    append_text(times, "CODId", "COD");
    append_text(times, "DwellId", "Dwell");
    if (!d.pulse) continue;
    xml_node used = p.append_child("TxRcv");
    append_text(used, "TxWFId", "Pulse");
    append_text(used, "RcvId", "Receiver");
  }
}

void put_pvp_slots(xml_node root, const CphdDescription& d) {
  constexpr std::size_t word = 8;
  xml_node node = root.append_child("PVP");
  for (const PvpSlot& slot : pvp_slots(d.encoding).first) {
    xml_node parameter = node.append_child(std::string(slot.field->name).c_str());
    append_count(parameter, "Offset", static_cast<long long>(slot.offset / word));
    append_count(parameter, "Size", static_cast<long long>(slot.field->words));
    append_text(parameter, "Format",
                slot.field->words == 3           ? "X=F8;Y=F8;Z=F8;"
                : slot.field->integer != nullptr ? "I8"
                                                 : "F8");
  }
}

void put_platform(xml_node node, const PlatformGeometry& g) {
  append_text(node, "SideOfTrack", std::string(1, g.side));
  append_number(node, "SlantRange", g.slant_range_m);
  append_number(node, "GroundRange", g.ground_range_m);
  append_number(node, "DopplerConeAngle", g.doppler_cone_deg);
  append_number(node, "GrazeAngle", g.graze_deg);
  append_number(node, "IncidenceAngle", g.incidence_deg);
  append_number(node, "AzimuthAngle", g.azimuth_deg);
}

void put_end(xml_node parent, const char* name, const PlatformGeometry& g) {
  xml_node node = parent.append_child(name);
  append_number(node, "Time", g.time_s);
  put_xyz(node, "Pos", g.position_m);
  put_xyz(node, "Vel", g.velocity_mps);
  put_platform(node, g);
}

void put_image_plane(xml_node node, const ReferenceGeometry& g) {
  append_number(node, "TwistAngle", g.twist_deg);
  append_number(node, "SlopeAngle", g.slope_deg);
  append_number(node, "LayoverAngle", g.layover_deg);
}

void put_geometry(xml_node root, const ReferenceGeometry& g) {
  xml_node node = root.append_child("ReferenceGeometry");
  xml_node srp = node.append_child("SRP");
  put_xyz(srp, "ECF", g.srp_m);
  put_xyz(srp, "IAC", g.srp_in_area_m);
  append_number(node, "ReferenceTime", g.time_s);
  append_number(node, "SRPCODTime", g.centre_time_s);
  append_number(node, "SRPDwellTime", g.dwell_s);
  if (!g.bistatic) {
    xml_node mono = node.append_child("Monostatic");
    put_xyz(mono, "ARPPos", g.platform.position_m);
    put_xyz(mono, "ARPVel", g.platform.velocity_mps);
    put_platform(mono, g.platform);
    put_image_plane(mono, g);
    return;
  }
  xml_node two = node.append_child("Bistatic");
  append_number(two, "AzimuthAngle", g.azimuth_deg);
  append_number(two, "AzimuthAngleRate", g.azimuth_rate_deg_per_s);
  append_number(two, "BistaticAngle", g.bistatic_deg);
  append_number(two, "BistaticAngleRate", g.bistatic_rate_deg_per_s);
  append_number(two, "GrazeAngle", g.graze_deg);
  put_image_plane(two, g);
  put_end(two, "TxPlatform", g.platform);
  put_end(two, "RcvPlatform", g.receiver);
}

void put_pulse(xml_node root, const CphdDescription& d) {
  const TransmittedPulse& p = *d.pulse;
  xml_node node = root.append_child("TxRcv");
  append_count(node, "NumTxWFs", 1);
  xml_node sent = node.append_child("TxWFParameters");
  append_text(sent, "Identifier", "Pulse");
  append_number(sent, "PulseLength", p.width_s);
  append_number(sent, "RFBandwidth", p.band_hz);
  append_number(sent, "FreqCenter", p.carrier_hz);
  if (p.rate_hz_per_s != 0.0) append_number(sent, "LFMRate", p.rate_hz_per_s);
  append_text(sent, "Polarization", d.channels.front().transmitted);
  append_count(node, "NumRcvs", 1);
  xml_node received = node.append_child("RcvParameters");
  append_text(received, "Identifier", "Receiver");
  append_number(received, "WindowLength", p.window_s);
  append_number(received, "SampleRate", p.sample_rate_hz);
  append_number(received, "IFFilterBW", p.sample_rate_hz);
  append_number(received, "FreqCenter", p.carrier_hz);
  append_text(received, "Polarization", d.channels.front().received);
}

}  // namespace

std::pair<std::vector<PvpSlot>, std::size_t> pvp_slots(SignalEncoding encoding) {
  constexpr std::size_t word = 8;
  std::vector<PvpSlot> slots;
  std::size_t offset = 0;
  for (const PvpField& field : pvp_fields()) {
    if (field.number == &PhaseVector::amplitude && encoding == SignalEncoding::cf8) continue;
    slots.push_back({&field, offset});
    offset += word * field.words;
  }
  return {slots, offset};
}

std::string cphd_xml(const CphdDescription& d) {
  pugi::xml_document document;
  xml_node root = document.append_child("CPHD");
  root.append_attribute("xmlns").set_value(("http://api.nsgreg.nga.mil/schema/cphd/" + d.version).c_str());
  put_collection(root, d);
  put_global(root, d);
  put_scene(root, d.scene, false);
  put_data(root, d);
  put_channels(root, d);
  put_pvp_slots(root, d);
  put_dwell(root, "Dwell", d.centre_time_s, d.dwell_s);
  if (d.geometry) put_geometry(root, *d.geometry);
  if (d.pulse) put_pulse(root, d);
  return core::xml_text(document);
}

}  // namespace sarsim::raster
