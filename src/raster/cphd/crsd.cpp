#include "raster/cphd/crsd.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include "core/xml/xml.hpp"
#include "raster/cphd/big_endian.hpp"
#include "raster/cphd/scene_xml.hpp"

namespace sarsim::raster {

namespace {

using core::append_count;
using core::append_number;
using core::append_text;
using pugi::xml_node;

constexpr std::size_t crsd_word = 8;

// Support arrays: the gain of the antenna, 0 dB in all directions, and the response of the transmitter, the same at all
// frequencies.
constexpr std::size_t gain_side = 3;
constexpr std::size_t response_length = 3;
constexpr std::size_t element_bytes = 8;

// One parameter of a pulse or of a row: name, kind and words.
struct CrsdField {
  const char* name;
  const char* format;
  std::size_t words;
};

constexpr const char* int_frac = "Int=I8;Frac=F8;";
constexpr const char* xyz = "X=F8;Y=F8;Z=F8;";
constexpr const char* beam = "DCX=F8;DCY=F8;";

constexpr std::array<CrsdField, 14> ppp_fields{{{"TxTime", int_frac, 2},
                                                {"TxPos", xyz, 3},
                                                {"TxVel", xyz, 3},
                                                {"FX1", "F8", 1},
                                                {"FX2", "F8", 1},
                                                {"TXmt", "F8", 1},
                                                {"PhiX0", int_frac, 2},
                                                {"FxFreq0", "F8", 1},
                                                {"FxRate", "F8", 1},
                                                {"TxRadInt", "F8", 1},
                                                {"TxACX", xyz, 3},
                                                {"TxACY", xyz, 3},
                                                {"TxEB", beam, 2},
                                                {"FxResponseIndex", "I8", 1}}};
constexpr std::array<CrsdField, 16> row_fields{{{"RcvStart", int_frac, 2},
                                                {"RcvPos", xyz, 3},
                                                {"RcvVel", xyz, 3},
                                                {"FRCV1", "F8", 1},
                                                {"FRCV2", "F8", 1},
                                                {"RefPhi0", int_frac, 2},
                                                {"RefFreq", "F8", 1},
                                                {"DFIC0", "F8", 1},
                                                {"FICRate", "F8", 1},
                                                {"RcvACX", xyz, 3},
                                                {"RcvACY", xyz, 3},
                                                {"RcvEB", beam, 2},
                                                {"SIGNAL", "I8", 1},
                                                {"AmpSF", "F8", 1},
                                                {"DGRGC", "F8", 1},
                                                {"TxPulseIndex", "I8", 1}}};

template <class Fields>
constexpr std::size_t bytes_of_fields(const Fields& fields) {
  std::size_t words = 0;
  for (const CrsdField& field : fields) words += field.words;
  return crsd_word * words;
}

template <class Fields>
void put_fields(xml_node root, const char* name, const Fields& fields) {
  xml_node node = root.append_child(name);
  std::size_t offset = 0;
  for (const CrsdField& field : fields) {
    xml_node parameter = node.append_child(field.name);
    append_count(parameter, "Offset", static_cast<long long>(offset));
    append_count(parameter, "Size", static_cast<long long>(field.words));
    append_text(parameter, "Format", field.format);
    offset += field.words;
  }
}

// Words one after the other.
class Words {
 public:
  explicit Words(std::size_t bytes) : bytes_(bytes) {}
  void put(double value) { put_big_endian(value, bytes_.data() + crsd_word * at_++); }
  void put(std::int64_t value) { put_big_endian(value, bytes_.data() + crsd_word * at_++); }
  void put(const core::Vec3& v) {
    put(v.x);
    put(v.y);
    put(v.z);
  }
  void put(const IntFrac& number) {
    put(number.whole);
    put(number.part);
  }
  void put_zeros(std::size_t words) { at_ += words; }
  [[nodiscard]] std::vector<std::byte> taken() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
};

void put_sensor(xml_node root, const char* name, const CrsdDescription& d) {
  xml_node node = root.append_child(name);
  append_text(node, "SensorName", d.sensor);
  append_text(node, "EventName", d.name);
}

void put_crsd_global(xml_node root, const CrsdDescription& d) {
  xml_node node = root.append_child("Global");
  append_text(node, "CollectionRefTime", d.start);
  xml_node sent = node.append_child("Transmit");
  append_number(sent, "TxTime1", d.tx_time1_s);
  append_number(sent, "TxTime2", d.tx_time2_s);
  append_number(sent, "FxMin", d.min_carrier_hz - 0.5 * d.band_hz);
  append_number(sent, "FxMax", d.max_carrier_hz + 0.5 * d.band_hz);
  xml_node received = node.append_child("Receive");
  append_number(received, "RcvStartTime1", d.rcv_start1_s);
  append_number(received, "RcvStartTime2", d.rcv_start2_s);
  append_number(received, "FrcvMin", d.min_carrier_hz - 0.5 * d.sample_rate_hz);
  append_number(received, "FrcvMax", d.max_carrier_hz + 0.5 * d.sample_rate_hz);
}

void put_support_size(xml_node node, const char* id, std::size_t rows, std::size_t columns, std::size_t offset) {
  xml_node array = node.append_child("SupportArray");
  append_text(array, "SAId", id);
  append_count(array, "NumRows", static_cast<long long>(rows));
  append_count(array, "NumCols", static_cast<long long>(columns));
  append_count(array, "BytesPerElement", static_cast<long long>(element_bytes));
  append_count(array, "ArrayByteOffset", static_cast<long long>(offset));
}

void put_crsd_data(xml_node root, const CrsdDescription& d) {
  xml_node node = root.append_child("Data");
  xml_node support = node.append_child("Support");
  append_count(support, "NumSupportArrays", 2);
  put_support_size(support, "Gain", gain_side, gain_side, 0);
  put_support_size(support, "Response", 1, response_length, element_bytes * gain_side * gain_side);
  xml_node sent = node.append_child("Transmit");
  append_count(sent, "NumBytesPPP", static_cast<long long>(bytes_of_fields(ppp_fields)));
  append_count(sent, "NumTxSequences", 1);
  xml_node sequence = sent.append_child("TxSequence");
  append_text(sequence, "TxId", "Pulses");
  append_count(sequence, "NumPulses", static_cast<long long>(d.pulses));
  append_count(sequence, "PPPArrayByteOffset", 0);
  xml_node received = node.append_child("Receive");
  append_text(received, "SignalArrayFormat", std::string(entry_of(d.encoding).name));
  append_count(received, "NumBytesPVP", static_cast<long long>(bytes_of_fields(row_fields)));
  append_count(received, "NumCRSDChannels", 1);
  xml_node channel = received.append_child("Channel");
  append_text(channel, "ChId", "1");
  append_count(channel, "NumVectors", static_cast<long long>(d.pulses));
  append_count(channel, "NumSamples", static_cast<long long>(d.samples));
  append_count(channel, "SignalArrayByteOffset", 0);
  append_count(channel, "PVPArrayByteOffset", 0);
}

void put_reference_point(xml_node parent, const char* name, const CrsdDescription& d) {
  xml_node node = parent.append_child(name);
  put_xyz(node, "ECF", d.geometry.srp_m);
  put_xy(node, "IAC", d.geometry.srp_in_area_m.x, d.geometry.srp_in_area_m.y);
}

// Vertical, which the axes of the antennas are laid for.
void put_polarisation(xml_node parent, const char* name) {
  xml_node node = parent.append_child(name);
  append_text(node, "PolarizationID", "V");
  append_number(node, "AmpH", 0.0);
  append_number(node, "AmpV", 1.0);
  append_number(node, "PhaseH", 0.0);
  append_number(node, "PhaseV", 0.0);
}

void put_sequence(xml_node root, const CrsdDescription& d) {
  xml_node node = root.append_child("TxSequence");
  append_text(node, "RefTxId", "Pulses");
  append_text(node, "TxWFType", "LFM");
  xml_node p = node.append_child("Parameters");
  append_text(p, "Identifier", "Pulses");
  append_count(p, "RefPulseIndex", static_cast<long long>(d.reference));
  append_text(p, "FxResponseId", "Response");
  put_flag(p, "FxBWFixed", d.min_carrier_hz == d.max_carrier_hz);
  append_number(p, "FxC", 0.5 * (d.min_carrier_hz + d.max_carrier_hz));
  append_number(p, "FxBW", d.max_carrier_hz - d.min_carrier_hz + d.band_hz);
  append_number(p, "TXmtMin", d.width_s);
  append_number(p, "TXmtMax", d.width_s);
  append_number(p, "TxTime1", d.tx_time1_s);
  append_number(p, "TxTime2", d.tx_time2_s);
  append_text(p, "TxAPCId", "Antenna");
  append_text(p, "TxAPATId", "Pattern");
  put_reference_point(p, "TxRefPoint", d);
  put_polarisation(p, "TxPolarization");
  append_number(p, "TxRefRadIntensity", 0.0);
  append_number(p, "TxRadIntErrorStdDev", 0.0);
  append_number(p, "TxRefLAtm", 0.0);
}

void put_crsd_channel(xml_node root, const CrsdDescription& d) {
  const bool fixed = d.min_carrier_hz == d.max_carrier_hz;
  xml_node node = root.append_child("Channel");
  append_text(node, "RefChId", "1");
  xml_node p = node.append_child("Parameters");
  append_text(p, "Identifier", "1");
  append_count(p, "RefVectorIndex", static_cast<long long>(d.reference));
  put_flag(p, "RefFreqFixed", fixed);
  put_flag(p, "FrcvFixed", fixed);
  put_flag(p, "SignalNormal", true);
  append_number(p, "F0Ref", d.reference_carrier_hz);
  append_number(p, "Fs", d.sample_rate_hz);
  append_number(p, "BWInst", d.band_hz);
  append_number(p, "RcvStartTime1", d.rcv_start1_s);
  append_number(p, "RcvStartTime2", d.rcv_start2_s);
  append_number(p, "FrcvMin", d.min_carrier_hz - 0.5 * d.sample_rate_hz);
  append_number(p, "FrcvMax", d.max_carrier_hz + 0.5 * d.sample_rate_hz);
  append_text(p, "RcvAPCId", "Antenna");
  append_text(p, "RcvAPATId", "Pattern");
  put_reference_point(p, "RcvRefPoint", d);
  put_polarisation(p, "RcvPolarization");
  append_number(p, "RcvRefIrradiance", 0.0);
  append_number(p, "RcvIrradianceErrorStdDev", 0.0);
  append_number(p, "RcvRefLAtm", 0.0);
  append_number(p, "PNCRSD", d.noise_w);
  append_number(p, "BNCRSD", 1.0);
  xml_node image = p.append_child("SARImage");
  append_text(image, "TxId", "Pulses");
  append_count(image, "RefVectorPulseIndex", static_cast<long long>(d.reference));
  put_polarisation(image, "TxPolarization");
  xml_node dwell = image.append_child("DwellTimes").append_child("Polynomials");
  append_text(dwell, "CODId", "COD");
  append_text(dwell, "DwellId", "Dwell");
  put_area(image, d.scene.area, true);
}

void put_angles(xml_node node, const PlatformGeometry& g, double squint_deg) {
  append_text(node, "SideOfTrack", std::string(1, g.side));
  append_number(node, "SlantRange", g.slant_range_m);
  append_number(node, "GroundRange", g.ground_range_m);
  append_number(node, "DopplerConeAngle", g.doppler_cone_deg);
  append_number(node, "SquintAngle", squint_deg);
  append_number(node, "AzimuthAngle", g.azimuth_deg);
  append_number(node, "GrazeAngle", g.graze_deg);
  append_number(node, "IncidenceAngle", g.incidence_deg);
}

void put_one_way(xml_node parent, const char* name, const PlatformGeometry& g, double squint_deg) {
  xml_node node = parent.append_child(name);
  append_number(node, "Time", g.time_s);
  put_xyz(node, "APCPos", g.position_m);
  put_xyz(node, "APCVel", g.velocity_mps);
  put_angles(node, g, squint_deg);
}

void put_crsd_geometry(xml_node root, const CrsdDescription& d) {
  const ReferenceGeometry& g = d.geometry;
  xml_node node = root.append_child("ReferenceGeometry");
  put_reference_point(node, "RefPoint", d);
  xml_node image = node.append_child("SARImage");
  append_number(image, "CODTime", g.centre_time_s);
  append_number(image, "DwellTime", g.dwell_s);
  append_number(image, "ReferenceTime", g.time_s);
  put_xyz(image, "ARPPos", d.middle.position_m);
  put_xyz(image, "ARPVel", d.middle.velocity_mps);
  append_number(image, "BistaticAngle", g.bistatic_deg);
  append_number(image, "BistaticAngleRate", g.bistatic_rate_deg_per_s);
  put_angles(image, d.middle, d.middle_squint_deg);
  append_number(image, "TwistAngle", g.twist_deg);
  append_number(image, "SlopeAngle", g.slope_deg);
  append_number(image, "LayoverAngle", g.layover_deg);
  put_one_way(node, "TxParameters", g.platform, d.tx_squint_deg);
  put_one_way(node, "RcvParameters", g.receiver, d.rcv_squint_deg);
}

void put_support(xml_node root, const CrsdDescription& d) {
  xml_node node = root.append_child("SupportArray");
  xml_node gain = node.append_child("GainPhaseArray");
  append_text(gain, "Identifier", "Gain");
  append_text(gain, "ElementFormat", "Gain=F4;Phase=F4;");
  append_number(gain, "X0", -0.5);
  append_number(gain, "Y0", -0.5);
  append_number(gain, "XSS", 0.5);
  append_number(gain, "YSS", 0.5);
  xml_node response = node.append_child("FxResponseArray");
  append_text(response, "Identifier", "Response");
  append_text(response, "ElementFormat", "Amp=F4;Phase=F4;");
  const double low_hz = d.min_carrier_hz - 0.5 * d.band_hz;
  append_number(response, "Fx0FXR", low_hz);
  append_number(response, "FxSSFXR", 0.5 * (d.max_carrier_hz + 0.5 * d.band_hz - low_hz));
}

void put_scale(xml_node parent, const char* name) {
  xml_node node = parent.append_child(name);
  append_number(node, "DCXSF", 0.0);
  append_number(node, "DCYSF", 0.0);
}

void put_antenna(xml_node root, const CrsdDescription& d) {
  xml_node node = root.append_child("Antenna");
  append_count(node, "NumACFs", 1);
  append_count(node, "NumAPCs", 1);
  append_count(node, "NumAPATs", 1);
  append_text(node.append_child("AntCoordFrame"), "Identifier", "Frame");
  xml_node centre = node.append_child("AntPhaseCenter");
  append_text(centre, "Identifier", "Antenna");
  append_text(centre, "ACFId", "Frame");
  put_xyz(centre, "APCXYZ", {});
  xml_node pattern = node.append_child("AntPattern");
  append_text(pattern, "Identifier", "Pattern");
  append_number(pattern, "FreqZero", d.reference_carrier_hz);
  append_text(pattern, "ArrayGPId", "Gain");
  append_text(pattern, "ElemGPId", "Gain");
  put_scale(pattern, "EBFreqShift");
  put_scale(pattern, "MLFreqDilation");
  xml_node boresight = pattern.append_child("GainBSPoly");
  boresight.append_attribute("order1").set_value(0);
  append_number(boresight, "Coef", 0.0).append_attribute("exponent1").set_value(0);
  xml_node polarisation = pattern.append_child("AntPolRef");
  append_number(polarisation, "AmpX", 0.0);
  append_number(polarisation, "AmpY", 1.0);
  append_number(polarisation, "PhaseX", 0.0);
  append_number(polarisation, "PhaseY", 0.0);
}

}  // namespace

IntFrac IntFrac::of(double value) {
  const double whole = std::floor(value);
  return {static_cast<std::int64_t>(whole), value - whole};
}

std::string crsd_xml(const CrsdDescription& d) {
  pugi::xml_document document;
  xml_node root = document.append_child("CRSDsar");
  root.append_attribute("xmlns").set_value("http://api.nsgreg.nga.mil/schema/crsd/1.0");
  xml_node product = root.append_child("ProductInfo");
  append_text(product, "ProductName", d.name);
  append_text(product, "Classification", "UNCLASSIFIED");
  append_text(product, "ReleaseInfo", "UNRESTRICTED");
  for (const auto& [name, value] : d.parameters) put_parameter(product, name, value);
  xml_node imaging = root.append_child("SARInfo");
  append_text(imaging, "CollectType", "MONOSTATIC");
  append_text(imaging.append_child("RadarMode"), "ModeType", d.mode);
  put_sensor(root, "TransmitInfo", d);
  put_sensor(root, "ReceiveInfo", d);
  put_crsd_global(root, d);
  put_scene(root, d.scene, true);
  put_crsd_data(root, d);
  put_sequence(root, d);
  put_crsd_channel(root, d);
  put_crsd_geometry(root, d);
  put_dwell(root, "DwellPolynomials", d.centre_time_s, d.dwell_s);
  put_support(root, d);
  put_fields(root, "PPP", ppp_fields);
  put_fields(root, "PVP", row_fields);
  put_antenna(root, d);
  return core::xml_text(document);
}

CrsdWriter::CrsdWriter(const std::filesystem::path& path, CrsdDescription description, bool replace)
    : file_(path, replace), description_(std::move(description)) {
  if (!file_.seekable())
    throw std::system_error(ESPIPE, std::generic_category(), "cannot write CRSD into a pipe: " + path.string());
  const CrsdDescription& d = description_;
  signal_bytes_ = d.samples * entry_of(d.encoding).bytes;
  const std::string xml = crsd_xml(d);
  std::array<FileBlock, 5> blocks{{{"XML", xml.size(), 0},
                                   {"SUPPORT", element_bytes * (gain_side * gain_side + response_length), 0},
                                   {"PPP", std::uint64_t{d.pulses} * bytes_of_fields(ppp_fields), 0},
                                   {"PVP", std::uint64_t{d.pulses} * bytes_of_fields(row_fields), 0},
                                   {"SIGNAL", std::uint64_t{d.pulses} * signal_bytes_, 0}}};
  place_blocks(blocks);
  support_ = blocks[1];
  ppp_ = blocks[2];
  pvp_ = blocks[3];
  signal_ = blocks[4];
  write_block_header(file_, "CRSDsar/1.0", blocks, "UNCLASSIFIED", "UNRESTRICTED", xml);
  write_support();
  file_.resize(signal_.offset + signal_.bytes);
}

// The gain is 0 dB and 0 cycles everywhere, the response 1 and 0 cycles.
void CrsdWriter::write_support() {
  std::vector<std::byte> bytes(static_cast<std::size_t>(support_.bytes));
  for (std::size_t i = 0; i < response_length; ++i)
    put_big_endian(1.0F, bytes.data() + element_bytes * (gain_side * gain_side + i));
  file_.write_at(support_.offset, bytes);
}

std::vector<std::byte> CrsdWriter::pulse_bytes(const ReceivedPulse& p) const {
  Words words(bytes_of_fields(ppp_fields));
  words.put(IntFrac::of(p.tx_time_s));
  words.put(p.tx_m);
  words.put(p.tx_mps);
  words.put(p.carrier_hz - 0.5 * description_.band_hz);
  words.put(p.carrier_hz + 0.5 * description_.band_hz);
  words.put(description_.width_s);
  words.put_zeros(2);  // PhiX0: the phase of the pulse's middle is 0.
  words.put(p.carrier_hz);
  words.put(p.rate_hz_per_s);
  words.put_zeros(1);  // TxRadInt, dB
  words.put(p.tx_x);
  words.put(p.tx_y);
  words.put_zeros(3);  // TxEB, FxResponseIndex
  return words.taken();
}

EncodedVector CrsdWriter::encode(const ReceivedPulse& p, std::size_t row,
                                 std::span<const std::complex<double>> samples) const {
  auto [signal, scale] = encode_samples(samples, description_.encoding);
  Words words(bytes_of_fields(row_fields));
  words.put(IntFrac::of(p.rcv_start_s));
  words.put(p.rcv_m);
  words.put(p.rcv_mps);
  words.put(p.carrier_hz - 0.5 * description_.sample_rate_hz);
  words.put(p.carrier_hz + 0.5 * description_.sample_rate_hz);
  words.put(IntFrac::of(p.phase_cycles));
  words.put(p.carrier_hz);
  words.put_zeros(2);  // DFIC0, FICRate: nothing is dechirped.
  words.put(p.rcv_x);
  words.put(p.rcv_y);
  words.put_zeros(2);  // RcvEB
  words.put(std::int64_t{1});
  words.put(scale);
  words.put(1.0);  // DGRGC
  words.put(static_cast<std::int64_t>(row));
  return {words.taken(), std::move(signal)};
}

void CrsdWriter::append(std::span<const std::byte> pulse, const EncodedVector& row) {
  if (written_ == description_.pulses || pulse.size() != bytes_of_fields(ppp_fields) ||
      row.pvp.size() != bytes_of_fields(row_fields) || row.signal.size() != signal_bytes_)
    throw std::logic_error("CRSD: a row that the file has no room for");
  file_.write_at(ppp_.offset + std::uint64_t{written_} * pulse.size(), pulse);
  file_.write_at(pvp_.offset + std::uint64_t{written_} * row.pvp.size(), row.pvp);
  file_.write_at(signal_.offset + std::uint64_t{written_} * signal_bytes_, row.signal);
  ++written_;
}

void CrsdWriter::finish() {
  if (written_ != description_.pulses) throw std::logic_error("CRSD: rows are missing");
  file_.commit();
}

}  // namespace sarsim::raster
