#include "raster/cphd/cphd_file.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/text/quoted_word.hpp"
#include "core/xml/xml.hpp"
#include "raster/cphd/big_endian.hpp"
#include "raster/cphd/vector_check.hpp"
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

}  // namespace sarsim::raster
