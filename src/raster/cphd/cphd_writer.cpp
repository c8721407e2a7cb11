#include "raster/cphd/cphd_writer.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/report/expect.hpp"
#include "raster/cphd/big_endian.hpp"

namespace sarsim::raster {

namespace {

template <class Integer>
std::vector<std::byte> integers_of(std::span<const std::complex<double>> samples, double scale) {
  std::vector<std::byte> bytes(2 * sizeof(Integer) * samples.size());
  std::byte* to = bytes.data();
  for (const std::complex<double>& sample : samples)
    for (const double part : {sample.real(), sample.imag()}) {
      put_big_endian(static_cast<Integer>(std::lround(part / scale)), to);
      to += sizeof(Integer);
    }
  return bytes;
}

std::vector<std::byte> floats_of(std::span<const std::complex<double>> samples) {
  std::vector<std::byte> bytes(2 * sizeof(float) * samples.size());
  std::byte* to = bytes.data();
  for (const std::complex<double>& sample : samples)
    for (const double part : {sample.real(), sample.imag()}) {
      put_big_endian(static_cast<float>(part), to);
      to += sizeof(float);
    }
  return bytes;
}

std::vector<std::byte> pvp_of(const PhaseVector& vector, SignalEncoding encoding) {
  const auto [slots, size] = pvp_slots(encoding);
  std::vector<std::byte> bytes(size);
  for (const PvpSlot& slot : slots) put_pvp(*slot.field, vector, bytes.data() + slot.offset);
  return bytes;
}

// The description with everything that follows from the shape of its channel.
CphdDescription with_sizes(CphdDescription description) {
  core::expect(description.channels.size() == 1, "CPHD: one channel is written");
  description.pvp_bytes = pvp_slots(description.encoding).second;
  description.channels.front().signal_offset = 0;
  description.channels.front().pvp_offset = 0;
  return description;
}

}  // namespace

std::pair<std::vector<std::byte>, double> encode_samples(std::span<const std::complex<double>> samples,
                                                         SignalEncoding encoding) {
  if (encoding == SignalEncoding::cf8) return {floats_of(samples), 1.0};
  double largest = 0.0;
  for (const std::complex<double>& sample : samples)
    largest = std::max({largest, std::abs(sample.real()), std::abs(sample.imag())});
  const double scale = largest > 0.0 ? largest / entry_of(encoding).largest : 1.0;
  return {encoding == SignalEncoding::ci4 ? integers_of<std::int16_t>(samples, scale)
                                          : integers_of<std::int8_t>(samples, scale),
          scale};
}

EncodedVector encode_vector(PhaseVector vector, std::span<const std::complex<double>> samples,
                            SignalEncoding encoding) {
  auto [signal, scale] = encode_samples(samples, encoding);
  vector.amplitude = scale;
  return {pvp_of(vector, encoding), std::move(signal)};
}

CphdWriter::CphdWriter(const std::filesystem::path& path, CphdDescription description, bool replace)
    : file_(path, replace), description_(with_sizes(std::move(description))) {
  if (!file_.seekable())
    throw std::system_error(ESPIPE, std::generic_category(), "cannot write CPHD into a pipe: " + path.string());
  const PhaseChannel& channel = description_.channels.front();
  signal_bytes_ = channel.samples * entry_of(description_.encoding).bytes;
  const std::string xml = cphd_xml(description_);
  std::array<FileBlock, 3> blocks{{{"XML", xml.size(), 0},
                                   {"PVP", std::uint64_t{channel.vectors} * description_.pvp_bytes, 0},
                                   {"SIGNAL", std::uint64_t{channel.vectors} * signal_bytes_, 0}}};
  place_blocks(blocks);
  pvp_ = blocks[1];
  signal_ = blocks[2];
  write_block_header(file_, "CPHD/" + description_.version, blocks, description_.classification, description_.release,
                     xml);
  file_.resize(signal_.offset + signal_.bytes);
}

void CphdWriter::append(const EncodedVector& vector) {
  if (written_ == description_.channels.front().vectors || vector.pvp.size() != description_.pvp_bytes ||
      vector.signal.size() != signal_bytes_)
    throw std::logic_error("CPHD: a vector that the file has no room for");
  file_.write_at(pvp_.offset + std::uint64_t{written_} * description_.pvp_bytes, vector.pvp);
  file_.write_at(signal_.offset + std::uint64_t{written_} * signal_bytes_, vector.signal);
  ++written_;
}

void CphdWriter::finish() {
  if (written_ != description_.channels.front().vectors) throw std::logic_error("CPHD: vectors are missing");
  file_.commit();
}

}  // namespace sarsim::raster
