#include "raster/cphd/block_file.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::raster {

namespace {

constexpr std::string_view section_end = "\f\n";
constexpr std::uint64_t xml_offset = 1024;
constexpr std::uint64_t alignment = 64;

void write_text(core::OutputFile& file, std::uint64_t offset, std::string_view text) {
  file.write_at(offset, std::as_bytes(std::span(text)));
}

}  // namespace

void place_blocks(std::span<FileBlock> blocks) {
  std::uint64_t next = xml_offset;
  for (FileBlock& block : blocks) {
    block.offset = next;
    const std::uint64_t end = next + block.bytes + (&block == blocks.data() ? section_end.size() : 0);
    next = (end + alignment - 1) / alignment * alignment;
  }
}

void write_block_header(core::OutputFile& file, std::string_view first_line, std::span<const FileBlock> blocks,
                        const std::string& classification, const std::string& release, std::string_view xml) {
  std::string header = fmt::format("{}\n", first_line);
  for (const FileBlock& block : blocks) {
    header += fmt::format("{}_BLOCK_SIZE := {}\n", block.name, block.bytes);
    header += fmt::format("{}_BLOCK_BYTE_OFFSET := {}\n", block.name, block.offset);
  }
  header += fmt::format("CLASSIFICATION := {}\nRELEASE_INFO := {}\n{}", classification, release, section_end);
  write_text(file, 0, header);
  write_text(file, blocks.front().offset, xml);
  write_text(file, blocks.front().offset + xml.size(), section_end);
}

std::optional<std::uint64_t> BlockHeader::number(const std::string& key) const {
  const auto found = values.find(key);
  if (found == values.end()) return std::nullopt;
  return core::parse_whole(found->second);
}

std::optional<FileBlock> BlockHeader::block(const std::string& name) const {
  const auto bytes = number(name + "_BLOCK_SIZE");
  const auto offset = number(name + "_BLOCK_BYTE_OFFSET");
  if (!bytes || !offset) return std::nullopt;
  return FileBlock{name, *bytes, *offset};
}

std::optional<BlockHeader> read_block_header(const core::InputFile& file) {
  constexpr std::size_t longest = std::size_t{64} << 10U;
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(file.size(), longest)), '\0');
  text.resize(file.read_at(0, std::as_writable_bytes(std::span(text))));
  const std::size_t end = text.find(section_end);
  if (end == std::string::npos) return std::nullopt;
  BlockHeader header;
  std::string_view rest = std::string_view(text).substr(0, end);
  for (bool first = true; !rest.empty(); first = false) {
    const std::size_t line_end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, line_end);
    rest.remove_prefix(std::min(line_end + 1, rest.size()));
    if (first) {
      header.first_line = core::trimmed(line);
      continue;
    }
    const std::size_t sign = line.find(":=");
    if (sign == std::string_view::npos) continue;
    const std::string key(core::trimmed(line.substr(0, sign)));
    const std::string value(core::trimmed(line.substr(sign + 2)));
    const auto [entry, is_new] = header.values.try_emplace(key, value);
    if (!is_new && entry->second != value && header.twice.empty()) header.twice = key;
  }
  return header;
}

}  // namespace sarsim::raster
