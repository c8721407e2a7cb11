// CPHD files: header, XML, parameters and samples. The first bytes are put there, so that every input is taken for one.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "raster/cphd/cphd_file.hpp"
#include "raster_probe.hpp"

namespace {

using sarsim::raster::CphdFile;

// Everything that a reader would ask for: first and last vector of every channel.
void read_channels(const CphdFile& file) {
  constexpr std::size_t max_samples = std::size_t{1} << 16U;
  for (std::size_t c = 0; c < file.description().channels.size(); ++c) {
    const sarsim::raster::PhaseChannel& channel = file.description().channels[c];
    std::vector<std::complex<float>> samples(std::min(channel.samples, max_samples));
    for (const std::size_t vector : {std::size_t{0}, channel.vectors - 1}) {
      sarsim::raster::PhaseVector read;
      file.read_vectors(c, vector, std::span(&read, 1));
      file.read_samples(c, vector, read.amplitude, samples);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view signature = "CPHD/";
  std::string bytes(reinterpret_cast<const char*>(data), size);
  bytes.resize(std::max(bytes.size(), signature.size()));
  std::ranges::copy(signature, bytes.begin());
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(bytes.data());
  sarsim::raster::probe_raster(begin, bytes.size(), {});
  const sarsim::raster::MemoryFile memory(begin, bytes.size());
  auto input = sarsim::core::InputFile::open(memory.path());
  sarsim::core::Problems problems;
  const auto file = CphdFile::open(std::move(std::get<sarsim::core::InputFile>(input)), problems);
  if ((file != nullptr) == sarsim::core::has_errors(problems))
    throw std::logic_error("a file without errors or errors without a file are promised");
  if (file) read_channels(*file);
  return 0;
}
