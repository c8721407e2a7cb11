#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/os/input_file.hpp"
#include "core/os/output_file.hpp"

/// What CPHD and CRSD files have in common: a header of text, XML, and blocks of numbers at places that it names.
namespace sarsim::raster {

/// A block of such a file.
struct FileBlock {
  std::string name;          ///< As its keys begin: "XML", "PVP", "SIGNAL".
  std::uint64_t bytes = 0;   ///< Its size.
  std::uint64_t offset = 0;  ///< In the file.
};

/// Gives blocks their places: XML from byte 1024 on, as a reader of pages of that size wants it, the others behind it
/// at multiples of 64 bytes.
/// @param blocks  XML first, then in the order of the file
void place_blocks(std::span<FileBlock> blocks);

/// Writes header and XML of a file whose blocks have their places; what lies between them is 0.
/// @param first_line  "CPHD/1.1.0"
void write_block_header(core::OutputFile& file, std::string_view first_line, std::span<const FileBlock> blocks,
                        const std::string& classification, const std::string& release, std::string_view xml);

/// The header of such a file.
struct BlockHeader {
  std::string first_line;
  std::map<std::string, std::string> values;
  std::string twice;  ///< A key that is there more than once, with other values; empty: none.

  /// A size or an offset, or nothing.
  [[nodiscard]] std::optional<std::uint64_t> number(const std::string& key) const;
  /// The block of that name, or nothing.
  [[nodiscard]] std::optional<FileBlock> block(const std::string& name) const;
};

/// Reads the header, at most 64 KiB of it; nothing where it does not end with the bytes 0C 0A.
[[nodiscard]] std::optional<BlockHeader> read_block_header(const core::InputFile& file);

}  // namespace sarsim::raster
