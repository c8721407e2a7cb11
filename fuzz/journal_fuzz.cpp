// Journals of recordings in parts: as they are, and with every line sealed anew so that what stands behind the seals is
// reached, too. What is understood can be written and understood again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "core/hash/checksum.hpp"
#include "raster/parts/journal.hpp"

namespace {

std::string sealed_anew(const std::string& text) {
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    line = line.substr(0, line.rfind(" #"));
    all += fmt::format("{} #{:016x}\n", line, sarsim::core::checksum_of(line));
  }
  return all;
}

void read_and_write(const std::string& text) {
  const auto read = sarsim::raster::parse_journal("fuzz.journal", text);
  const auto* journal = std::get_if<sarsim::raster::Journal>(&read);
  if (journal == nullptr) return;
  std::string again = sarsim::raster::text_of(journal->head);
  for (const sarsim::raster::Claim& claim : journal->claims) again += sarsim::raster::text_of(claim);
  const auto reread = sarsim::raster::parse_journal("fuzz.journal", again);
  const auto* same = std::get_if<sarsim::raster::Journal>(&reread);
  if (same == nullptr || same->claims.size() != journal->claims.size() ||
      same->head.identity.size() != journal->head.identity.size() || journal->bytes > text.size())
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read_and_write(text);
  read_and_write(sealed_anew(text));
  return 0;
}
