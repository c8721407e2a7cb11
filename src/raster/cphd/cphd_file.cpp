#include "raster/cphd/cphd_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/task/stop_points.hpp"
#include "core/text/quoted_word.hpp"
#include "core/xml/xml.hpp"
#include "radar/earth/earth_depth.hpp"
#include "raster/cphd/big_endian.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/nearest_float.hpp"

namespace sarsim::raster {

namespace {

core::Problem cphd_problem(const core::InputFile& file, std::string message, std::string found, std::string expected,
                           std::string hint = {}) {
  return file_problem(file.path().string(), std::move(message), std::move(found), std::move(expected), std::move(hint));
}

// Whether a block lies within the file.
bool fits(const FileBlock& block, std::uint64_t file_bytes) {
  return block.offset <= file_bytes && block.bytes <= file_bytes - block.offset;
}

// A block of the header that is there and lies within the file.
std::optional<FileBlock> sound_block(const core::InputFile& file, const BlockHeader& header, const std::string& name,
                                     core::Problems& problems) {
  const auto block = header.block(name);
  if (!block) {
    problems.push_back(cphd_problem(file, fmt::format("the header does not say where the block {} is", name), {},
                                    fmt::format("{0}_BLOCK_SIZE and {0}_BLOCK_BYTE_OFFSET", name)));
    return std::nullopt;
  }
  if (fits(*block, file.size())) return block;
  problems.push_back(cphd_problem(file, fmt::format("the block {} reaches beyond the end of the file", name),
                                  fmt::format("{} bytes from {} on", block->bytes, block->offset),
                                  fmt::format("at most {} bytes", file.size()), "the file is cut off"));
  return std::nullopt;
}

bool is_known_version(const std::string& line) { return line == "CPHD/1.0.1" || line == "CPHD/1.1.0"; }

// Errors, or remarks on the first line of the header.
void check_version(const core::InputFile& file, const std::string& line, core::Problems& problems) {
  if (is_known_version(line)) return;
  if (line.starts_with("CPHD/1.")) {
    problems.push_back(with_severity(cphd_problem(file, "this version of CPHD is not known; it is read as 1.1.0",
                                                  core::quoted_word(line), "CPHD/1.0.1 or CPHD/1.1.0"),
                                     core::Severity::warning));
    return;
  }
  problems.push_back(cphd_problem(file, "the file is not CPHD of version 1", core::quoted_word(line),
                                  "CPHD/1.0.1 or CPHD/1.1.0 in the first line"));
}

// Whether the arrays of all channels lie within their blocks.
void check_channels(const core::InputFile& file, const CphdDescription& d, const FileBlock& pvp,
                    const FileBlock& signal, core::Problems& problems) {
  for (const PhaseChannel& channel : d.channels) {
    const auto check = [&](const char* what, const FileBlock& block, std::uint64_t offset, std::uint64_t bytes,
                           std::uint64_t items) {
      const auto size = checked_product(channel.vectors, bytes, items);
      if (size && offset <= block.bytes && *size <= block.bytes - offset) return;
      problems.push_back(cphd_problem(
          file, fmt::format("the {} of channel '{}' do not fit into the block {}", what, channel.id, block.name),
          fmt::format("{} vectors of {} bytes from {} on", channel.vectors, bytes * items, offset),
          fmt::format("at most {} bytes", block.bytes)));
    };
    check("parameters", pvp, channel.pvp_offset, d.pvp_bytes, 1);
    check("samples", signal, channel.signal_offset, entry_of(d.encoding).bytes, channel.samples);
  }
}

// Whether the arrays of the channels fill their block, each array at a place of its own.
void check_block(const core::InputFile& file, const FileBlock& block, const char* what,
                 std::vector<std::pair<std::uint64_t, std::uint64_t>> arrays, core::Problems& problems) {
  std::ranges::sort(arrays);
  std::uint64_t end = 0;
  std::uint64_t bytes = 0;
  for (const auto& [offset, size] : arrays) {
    if (offset < end)
      problems.push_back(cphd_problem(file, fmt::format("the {} of two channels lie at one place", what),
                                      fmt::format("an array from {} on, the one before ends at {}", offset, end),
                                      "arrays one behind the other"));
    end = std::max(end, offset + size);
    bytes += size;
  }
  if (bytes != block.bytes)
    problems.push_back(with_severity(
        cphd_problem(file, fmt::format("the {} of all channels do not fill the block {}", what, block.name),
                     fmt::format("{}_BLOCK_SIZE {} bytes", block.name, block.bytes),
                     fmt::format("{} bytes, as the XML counts vectors and samples", bytes),
                     "the header or the XML belongs to another file; what the XML counts is read"),
        core::Severity::warning));
}

void check_sums(const core::InputFile& file, const CphdDescription& d, const FileBlock& pvp, const FileBlock& signal,
                core::Problems& problems) {
  if (core::has_errors(problems)) return;  // The products below may not fit into 64 bits.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> parameters, samples;
  for (const PhaseChannel& channel : d.channels) {
    parameters.emplace_back(channel.pvp_offset, channel.vectors * d.pvp_bytes);
    samples.emplace_back(channel.signal_offset, channel.vectors * channel.samples * entry_of(d.encoding).bytes);
  }
  check_block(file, pvp, "parameters", std::move(parameters), problems);
  check_block(file, signal, "samples", std::move(samples), problems);
}

// Whether the blocks reach to the end of the file: of one whose offset is wrong, bytes are left over.
void check_end(const core::InputFile& file, const BlockHeader& header, core::Problems& problems) {
  constexpr std::uint64_t after_xml = 2;  // Bytes that end the section.
  std::uint64_t end = 0;
  for (const char* const name : {"XML", "SUPPORT", "PVP", "SIGNAL"})
    if (const auto block = header.block(name); block && fits(*block, file.size()))
      end = std::max(end, block->offset + block->bytes + (name == std::string_view("XML") ? after_xml : 0));
  if (end >= file.size()) return;
  problems.push_back(with_severity(
      cphd_problem(file, "bytes are left over behind the last block", fmt::format("{} bytes", file.size() - end),
                   fmt::format("a file of {} bytes, as its header says", end),
                   "the offset of a block may be wrong, or the file belongs to another header"),
      core::Severity::warning));
}

template <class Integer>
void scaled(std::span<const std::byte> bytes, double amplitude, std::span<std::complex<float>> out) {
  const std::byte* from = bytes.data();
  for (std::complex<float>& sample : out) {
    const double i = static_cast<double>(get_big_endian<Integer>(from));
    const double q = static_cast<double>(get_big_endian<Integer>(from + sizeof(Integer)));
    sample = {as_float(amplitude * i), as_float(amplitude * q)};
    from += 2 * sizeof(Integer);
  }
}

}  // namespace

std::shared_ptr<const CphdFile> CphdFile::open(core::InputFile input, core::Problems& problems,
                                               const core::StopFlag* stop) {
  std::shared_ptr<CphdFile> opened(new CphdFile(std::move(input)));
  const core::InputFile& file = opened->file_;
  const auto header = read_block_header(file);
  if (!header) {
    problems.push_back(cphd_problem(file, "the header of the CPHD file does not end", {},
                                    "the bytes 0C 0A within the first 64 KiB", "the file is cut off or not CPHD"));
    return nullptr;
  }
  check_version(file, header->first_line, problems);
  if (!header->twice.empty())
    problems.push_back(cphd_problem(file, "a key is in the header twice, with other values",
                                    core::quoted_word(header->twice), "each key once"));
  const auto xml = sound_block(file, *header, "XML", problems);
  const auto pvp = sound_block(file, *header, "PVP", problems);
  const auto signal = sound_block(file, *header, "SIGNAL", problems);
  if (xml && xml->bytes > core::longest_xml)
    problems.push_back(cphd_problem(file, "the XML is too long", fmt::format("{} bytes", xml->bytes),
                                    fmt::format("at most {} bytes", core::longest_xml)));
  if (core::has_errors(problems)) return nullptr;
  std::string text(static_cast<std::size_t>(xml->bytes), '\0');
  file.read_all_at(xml->offset, std::as_writable_bytes(std::span(text)));
  auto read = read_cphd_xml(text, file.path().string(), problems);
  if (!read) return nullptr;
  opened->description_ = std::move(read->first);
  opened->slots_ = std::move(read->second);
  opened->pvp_ = *pvp;
  opened->signal_ = *signal;
  if (is_known_version(header->first_line)) opened->description_.version = header->first_line.substr(5);
  check_channels(file, opened->description_, *pvp, *signal, problems);
  check_sums(file, opened->description_, *pvp, *signal, problems);
  check_end(file, *header, problems);
  if (core::has_errors(problems)) return nullptr;
  check_vectors(*opened, problems, stop);
  if (core::has_errors(problems)) return nullptr;
  return opened;
}

std::optional<std::size_t> CphdFile::channel_of(std::string_view id) const {
  if (id.empty()) return description_.reference_channel;
  const auto found = std::ranges::find(description_.channels, id, &PhaseChannel::id);
  if (found == description_.channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - description_.channels.begin());
}

void CphdFile::read_vectors(std::size_t channel, std::size_t first, std::span<PhaseVector> out) const {
  constexpr std::size_t together = 256;
  const PhaseChannel& c = description_.channels.at(channel);
  const std::size_t bytes = description_.pvp_bytes;
  std::vector<std::byte> buffer;
  for (std::size_t begin = 0; begin < out.size(); begin += together) {
    const std::size_t count = std::min(together, out.size() - begin);
    buffer.resize(count * bytes);
    file_.read_all_at(pvp_.offset + c.pvp_offset + std::uint64_t{first + begin} * bytes, buffer);
    for (std::size_t i = 0; i < count; ++i) {
      out[begin + i] = {};
      for (const PvpSlot& slot : slots_) get_pvp(*slot.field, buffer.data() + i * bytes + slot.offset, out[begin + i]);
    }
  }
}

void CphdFile::read_samples(std::size_t channel, std::size_t vector, double amplitude,
                            std::span<std::complex<float>> out) const {
  const PhaseChannel& c = description_.channels.at(channel);
  const std::size_t bytes = entry_of(description_.encoding).bytes * c.samples;
  std::vector<std::byte> buffer(entry_of(description_.encoding).bytes * out.size());
  file_.read_all_at(signal_.offset + c.signal_offset + std::uint64_t{vector} * bytes, buffer);
  switch (description_.encoding) {
    case SignalEncoding::cf8: scaled<float>(buffer, amplitude, out); break;
    case SignalEncoding::ci4: scaled<std::int16_t>(buffer, amplitude, out); break;
    case SignalEncoding::ci2: scaled<std::int8_t>(buffer, amplitude, out); break;
  }
}

namespace {

using V = PhaseVector;

// Beyond these there is no radar: a year, the speed of meteors, gamma rays.
constexpr double max_time_s = 3.2e7;
constexpr double max_speed_mps = 1e5;
constexpr double max_frequency_hz = 1e14;
constexpr double max_delay_s = 100.0;

// A number of a vector and between what it has to be.
struct Bounds {
  std::string_view name;
  double V::*number;
  double least;
  double most;
  const char* expected;
};

constexpr Bounds number_bounds[] = {
    {"TxTime", &V::tx_time_s, -max_time_s, max_time_s, "seconds after the start of the collection"},
    {"RcvTime", &V::rcv_time_s, -max_time_s, max_time_s, "seconds after the start of the collection"},
    {"AmpSF", &V::amplitude, std::numeric_limits<double>::min(), max_cphd_sample, "a number above 0, up to 1e28"},
    {"aFDOP", &V::doppler, -1e-2, 1e-2, "-0.01 to 0.01: the rate of the path over the speed of light"},
    {"aFRR1", &V::rate1, -1e30, 1e30, "a finite number"},
    {"aFRR2", &V::rate2, -1e30, 1e30, "a finite number"},
    {"FX1", &V::fx1_hz, 1.0, max_frequency_hz, "a frequency, 1 Hz to 1e14 Hz"},
    {"FX2", &V::fx2_hz, 1.0, max_frequency_hz, "a frequency, 1 Hz to 1e14 Hz"},
    {"TOA1", &V::toa1_s, -max_delay_s, max_delay_s, "-100 s to 100 s"},
    {"TOA2", &V::toa2_s, -max_delay_s, max_delay_s, "-100 s to 100 s"},
    {"TDTropoSRP", &V::tropo_s, -1e-3, 1e-3, "-1 ms to 1 ms"},
};

struct PlaceBounds {
  std::string_view name;
  core::Vec3 V::*place;
  double most;
  const char* expected;
};

constexpr PlaceBounds place_bounds[] = {
    {"TxPos", &V::tx_m, radar::farthest_place_m, "Earth-fixed metres, up to 4e9"},
    {"TxVel", &V::tx_mps, max_speed_mps, "up to 1e5 m/s"},
    {"RcvPos", &V::rcv_m, radar::farthest_place_m, "Earth-fixed metres, up to 4e9"},
    {"RcvVel", &V::rcv_mps, max_speed_mps, "up to 1e5 m/s"},
    {"SRPPos", &V::srp_m, radar::farthest_place_m, "Earth-fixed metres, up to 4e9"},
};

std::string text_of(const core::Vec3& v) { return fmt::format("({:g}, {:g}, {:g})", v.x, v.y, v.z); }

// What is wrong with a parameter, in words; the vector is known elsewhere.
struct VectorFault {
  std::string parameter;
  std::string found;
  std::string expected;
};

bool is_within(double value, double low, double high) { return value >= low && value <= high; }  // False for NaN.

std::optional<VectorFault> fault_of_numbers(const V& v) {
  for (const Bounds& bounds : number_bounds)
    if (!is_within(v.*bounds.number, bounds.least, bounds.most))
      return VectorFault{std::string(bounds.name), fmt::format("{:g}", v.*bounds.number), bounds.expected};
  for (const PlaceBounds& bounds : place_bounds)
    if (!(core::norm(v.*bounds.place) <= bounds.most))
      return VectorFault{std::string(bounds.name), text_of(v.*bounds.place), bounds.expected};
  return std::nullopt;
}

// @param samples  of a vector
std::optional<VectorFault> fault_of_samples(const V& v, PhaseDomain domain, std::size_t samples) {
  const bool fx = domain == PhaseDomain::fx;
  const double lowest = fx ? 1.0 : -max_delay_s;
  const double highest = fx ? max_frequency_hz : max_delay_s;
  const char* const expected = fx ? "a frequency, 1 Hz to 1e14 Hz" : "-100 s to 100 s";
  if (!is_within(v.first, lowest, highest)) return VectorFault{"SC0", fmt::format("{:g}", v.first), expected};
  if (!(v.step > 0.0) || !std::isfinite(1.0 / v.step))
    return VectorFault{"SCSS", fmt::format("{:g}", v.step), "an interval above 0"};
  // Echoes that arrive further apart than that lie on each other.
  constexpr double share = 0.99;
  const double kept_s = v.toa2_s - v.toa1_s;
  if (fx && 1.0 / v.step < share * kept_s)
    return VectorFault{"SCSS",
                       fmt::format("{:g} Hz, which tells times of arrival within {:g} s apart", v.step, 1.0 / v.step),
                       fmt::format("at most 1/(TOA2 - TOA1), {:g} Hz", 1.0 / kept_s)};
  const double last = v.first + static_cast<double>(samples - 1) * v.step;
  if (is_within(last, lowest, highest)) return std::nullopt;
  return VectorFault{
      "SCSS", fmt::format("{:g}", v.step),
      fmt::format("an interval with which the last of {} samples lies at most at {:g}", samples, highest)};
}

std::optional<VectorFault> fault_of_order(const V& v) {
  if (!(v.fx1_hz < v.fx2_hz))
    return VectorFault{"FX1", fmt::format("{:g} Hz", v.fx1_hz), fmt::format("below FX2, {:g} Hz", v.fx2_hz)};
  if (!(v.toa1_s < v.toa2_s))
    return VectorFault{"TOA1", fmt::format("{:g} s", v.toa1_s), fmt::format("below TOA2, {:g} s", v.toa2_s)};
  if (!(v.rcv_time_s >= v.tx_time_s))
    return VectorFault{"RcvTime", fmt::format("{:.12g} s", v.rcv_time_s),
                       fmt::format("TxTime, {:.12g} s, or later", v.tx_time_s)};
  if (!(v.rcv_time_s - v.tx_time_s <= max_delay_s))
    return VectorFault{"RcvTime", fmt::format("{:.12g} s", v.rcv_time_s),
                       fmt::format("at most {:g} s after TxTime, {:.12g} s", max_delay_s, v.tx_time_s)};
  return std::nullopt;
}

// Places where no radar and no scene is, and ways that are not those of the echo by a factor of three: the reference
// point, or the antenna, is elsewhere.
std::optional<VectorFault> fault_of_places(const V& v, const core::Vec3& origin_m) {
  for (const auto& [place, name] :
       {std::pair(&V::tx_m, "TxPos"), std::pair(&V::rcv_m, "RcvPos"), std::pair(&V::srp_m, "SRPPos")})
    if (const auto depth_m = radar::impossible_depth_m(v.*place))
      return VectorFault{
          name, fmt::format("{:.6g} m below the ellipsoid", *depth_m),
          fmt::format("Earth-fixed places (ECF) in metres, at most {:g} m below it", -radar::deepest_place_m)};
  constexpr double max_ratio = 3.0;
  const double way_m = v.reference_way_m();
  const double flown_m = core::exact_light_speed_mps * (v.rcv_time_s - v.tx_time_s);
  // Some files have no time under way.
  if (flown_m > 0.0 && !(way_m < max_ratio * flown_m && flown_m < max_ratio * way_m))
    return VectorFault{
        "the way from TxPos over SRPPos to RcvPos", fmt::format("{:.6g} m", way_m),
        fmt::format("about {:.6g} m, as RcvTime is {:.6g} s after TxTime", flown_m, v.rcv_time_s - v.tx_time_s)};
  constexpr double farthest_m = 1e7;
  const double apart_m = core::norm(v.srp_m - origin_m);
  if (!(apart_m <= farthest_m))
    return VectorFault{"SRPPos", fmt::format("{:.6g} m from IARP/ECF, the middle of the image area", apart_m),
                       fmt::format("at most {:g} m", farthest_m)};
  return std::nullopt;
}

// What is remarkable without being wrong beyond use, with the first vector of which it is true.
class Remark {
 public:
  void note(std::size_t vector, std::string found, std::string expected) {
    if (count_++ > 0) return;
    first_ = vector;
    found_ = std::move(found);
    expected_ = std::move(expected);
  }
  void report(const std::string& file, const PhaseChannel& channel, const char* what, const char* hint,
              core::Problems& problems) const {
    if (count_ == 0) return;
    problems.push_back(with_severity(file_problem(file,
                                                  fmt::format("channel '{}', {} of {} vectors: {}; the first is "
                                                              "vector {} (from 0)",
                                                              channel.id, count_, channel.vectors, what, first_),
                                                  found_, expected_, hint),
                                     core::Severity::warning));
  }

 private:
  std::size_t count_ = 0;
  std::size_t first_ = 0;
  std::string found_;
  std::string expected_;
};

// The vectors of one channel, one after the other.
class ChannelCheck {
 public:
  ChannelCheck(const CphdFile& file, std::size_t channel) : file_(file), number_(channel) {}

  void run(core::Problems& problems, const core::StopFlag* stop) {
    constexpr std::size_t together = 4096;
    std::vector<V> vectors;
    for (std::size_t first = 0; first < channel().vectors; first += together) {
      core::end_if_asked(stop);
      vectors.resize(std::min(together, channel().vectors - first));
      file_.read_vectors(number_, first, vectors);
      for (std::size_t i = 0; i < vectors.size(); ++i)
        if (auto fault = look_at(vectors[i], first + i)) return refuse(*fault, first + i, problems);
    }
    report(problems);
  }

 private:
  static constexpr double global_share = 0.01;  // Of what the XML says of all vectors: its digits are few.

  [[nodiscard]] const CphdDescription& description() const { return file_.description(); }
  [[nodiscard]] const PhaseChannel& channel() const { return description().channels[number_]; }
  [[nodiscard]] std::string name() const { return file_.file().path().string(); }

  void refuse(const VectorFault& fault, std::size_t vector, core::Problems& problems) const {
    problems.push_back(file_problem(
        name(), fmt::format("channel '{}', vector {} (from 0): {} cannot be", channel().id, vector, fault.parameter),
        fault.found, fault.expected, "the file is damaged, or its writer counts in other units"));
  }

  std::optional<VectorFault> look_at(const V& v, std::size_t i) {
    constexpr std::int64_t max_signal = 3;
    if (v.signal < 0 || v.signal > max_signal)
      return VectorFault{"SIGNAL", fmt::format("{}", v.signal), "a whole number: 0 without a signal, 1 with one"};
    if (v.signal == 0) return std::nullopt;  // Its parameters mean nothing.
    if (auto fault = fault_of_numbers(v)) return fault;
    if (auto fault = fault_of_samples(v, description().domain, channel().samples)) return fault;
    if (auto fault = fault_of_order(v)) return fault;
    if (auto fault = fault_of_places(v, description().scene.origin_m)) return fault;
    compare_times(v, i);
    compare_places(v, i);
    compare_bands(v, i);
    compare_arrivals(v, i);
    return std::nullopt;
  }

  void compare_times(const V& v, std::size_t i) {
    if (last_time_s_ && v.tx_time_s <= *last_time_s_)
      descending_.note(i, fmt::format("TxTime {:.12g} s after {:.12g} s", v.tx_time_s, *last_time_s_),
                       "ascending times");
    last_time_s_ = v.tx_time_s;
    // A tenth: vendors put the time of reception at other places of the receive window.
    constexpr double share = 0.1;
    const double way_s = v.reference_way_m() / core::exact_light_speed_mps;
    const double under_way_s = v.rcv_time_s - v.tx_time_s;
    if (std::abs(under_way_s - way_s) > share * way_s)
      late_.note(i, fmt::format("RcvTime {:.6g} s after TxTime", under_way_s),
                 fmt::format("{:.6g} s, as the ways to SRPPos are long", way_s));
  }

  void compare_places(const V& v, std::size_t i) {
    const double under_way_s = v.rcv_time_s - v.tx_time_s;
    // Some files have no motion while the echo is under way: the antenna stops for it.
    if (description().bistatic || !(under_way_s > 0.0) || core::norm(v.rcv_m - v.tx_m) < 1e-3) return;
    const double moved_m = core::norm(v.rcv_m - v.tx_m - (0.5 * under_way_s) * (v.tx_mps + v.rcv_mps));
    const double expected_m = core::norm((0.5 * under_way_s) * (v.tx_mps + v.rcv_mps));
    if (moved_m > 0.1 * expected_m + 1e-3)
      velocity_.note(i, fmt::format("RcvPos {:.6g} m from TxPos", core::norm(v.rcv_m - v.tx_m)),
                     fmt::format("{:.6g} m by TxVel and RcvVel", expected_m));
  }

  void compare_bands(const V& v, std::size_t i) {
    min_hz_ = std::min(min_hz_, v.fx1_hz);
    max_hz_ = std::max(max_hz_, v.fx2_hz);
    if (!first_) first_ = v;
    const PhaseChannel& c = channel();
    // The rounding of texts and of sums.
    const auto differ = [](double a, double b, double of) { return std::abs(a - b) > 1e-6 * std::abs(of); };
    if (c.fx_fixed && (differ(v.fx1_hz, first_->fx1_hz, v.fx1_hz) || differ(v.fx2_hz, first_->fx2_hz, v.fx2_hz)))
      flags_.note(i, fmt::format("FX1 {:.9g} Hz, FX2 {:.9g} Hz", v.fx1_hz, v.fx2_hz),
                  "those of the first vector, as FXFixed is true");
    if (c.toa_fixed && (differ(v.toa1_s, first_->toa1_s, v.toa2_s - v.toa1_s) ||
                        differ(v.toa2_s, first_->toa2_s, v.toa2_s - v.toa1_s)))
      flags_.note(i, fmt::format("TOA1 {:.9g} s, TOA2 {:.9g} s", v.toa1_s, v.toa2_s),
                  "those of the first vector, as TOAFixed is true");
    if (c.srp_fixed && core::norm(v.srp_m - first_->srp_m) > 1e-3)
      flags_.note(i, "SRPPos " + text_of(v.srp_m), "that of the first vector, as SRPFixed is true");
    const CphdDescription& d = description();
    const double spare_hz = global_share * (d.fx_max_hz - d.fx_min_hz);
    if (v.fx1_hz < d.fx_min_hz - spare_hz || v.fx2_hz > d.fx_max_hz + spare_hz)
      global_band_.note(i, fmt::format("FX1 {:.9g} Hz, FX2 {:.9g} Hz", v.fx1_hz, v.fx2_hz),
                        fmt::format("within Global/FxBand, {:.9g} Hz to {:.9g} Hz", d.fx_min_hz, d.fx_max_hz));
    if (d.domain == PhaseDomain::toa) return;
    const double last_hz = v.first + static_cast<double>(c.samples - 1) * v.step;
    const double room_hz = v.step + 1e-6 * v.fx2_hz;
    if (v.fx1_hz < v.first - room_hz || v.fx2_hz > last_hz + room_hz)
      band_.note(i, fmt::format("FX1 {:.9g} Hz, FX2 {:.9g} Hz", v.fx1_hz, v.fx2_hz),
                 fmt::format("within the samples, {:.9g} Hz to {:.9g} Hz", v.first, last_hz));
  }

  void compare_arrivals(const V& v, std::size_t i) {
    const CphdDescription& d = description();
    longest_s_ = std::max(longest_s_, v.toa2_s - v.toa1_s);
    const auto found = [&] { return fmt::format("TOA1 {:.6g} s, TOA2 {:.6g} s", v.toa1_s, v.toa2_s); };
    const double spare_s = global_share * (d.toa_max_s - d.toa_min_s);
    if (v.toa1_s < d.toa_min_s - spare_s || v.toa2_s > d.toa_max_s + spare_s)
      swath_.note(i, found(), fmt::format("within Global/TOASwath, {:.6g} s to {:.6g} s", d.toa_min_s, d.toa_max_s));
    if (d.domain == PhaseDomain::fx) return;
    const double last_s = v.first + static_cast<double>(channel().samples - 1) * v.step;
    const double room_s = v.step + global_share * (v.toa2_s - v.toa1_s);
    if (v.toa1_s < v.first - room_s || v.toa2_s > last_s + room_s)
      arrivals_.note(i, found(), fmt::format("within the samples, {:.6g} s to {:.6g} s", v.first, last_s));
  }

  void report(core::Problems& problems) const {
    const std::string file = name();
    const auto report = [&](const Remark& remark, const char* what, const char* hint = "") {
      remark.report(file, channel(), what, hint, problems);
    };
    report(descending_, "their times do not ascend", "sort the vectors by TxTime");
    report(late_, "the time of reception contradicts the places", "the speed of the antenna is taken from both");
    report(velocity_, "the velocities contradict the places", "the speed of the antenna is taken from the places");
    report(flags_, "they differ although the XML says that they do not");
    report(band_, "the band lies beyond the samples");
    report(global_band_, "the band lies beyond that of the XML");
    report(arrivals_, "the times of arrival lie beyond the samples");
    report(swath_, "the times of arrival lie beyond those of the XML",
           "focusing images the times that the vectors say");
    compare_channel(problems);
  }

  // FxC is the carrier of the image, so it has to be that of the vectors.
  void compare_channel(core::Problems& problems) const {
    const PhaseChannel& c = channel();
    if (first_ && c.toa_s > 0.0 && std::abs(c.toa_s - longest_s_) > global_share * longest_s_)
      problems.push_back(with_severity(
          file_problem(name(), fmt::format("channel '{}': TOASaved of the XML is not that of the vectors", c.id),
                       fmt::format("{:.6g} s", c.toa_s), fmt::format("{:.6g} s, the longest TOA2 - TOA1", longest_s_)),
          core::Severity::warning));
    if (!first_ || !(c.centre_hz > 0.0)) return;
    const double band_hz = max_hz_ - min_hz_;
    const double centre_hz = 0.5 * (min_hz_ + max_hz_);
    constexpr double share = 0.01;
    if (std::abs(c.centre_hz - centre_hz) <= share * band_hz && std::abs(c.band_hz - band_hz) <= share * band_hz)
      return;
    problems.push_back(with_severity(
        file_problem(name(), fmt::format("channel '{}': FxC and FxBW of the XML are not those of the vectors", c.id),
                     fmt::format("{:.9g} Hz, {:.9g} Hz wide", c.centre_hz, c.band_hz),
                     fmt::format("{:.9g} Hz, {:.9g} Hz wide, as FX1 and FX2 say", centre_hz, band_hz),
                     "the phase of the image is that about FxC"),
        core::Severity::warning));
  }

  const CphdFile& file_;
  std::size_t number_;
  std::optional<double> last_time_s_;
  std::optional<V> first_;
  double min_hz_ = std::numeric_limits<double>::infinity();
  double max_hz_ = -std::numeric_limits<double>::infinity();
  double longest_s_ = 0.0;
  Remark descending_, late_, velocity_, flags_, band_, global_band_, arrivals_, swath_;
};

}  // namespace

void check_vectors(const CphdFile& file, core::Problems& problems, const core::StopFlag* stop) {
  for (std::size_t i = 0; i < file.description().channels.size(); ++i) ChannelCheck(file, i).run(problems, stop);
}

}  // namespace sarsim::raster
