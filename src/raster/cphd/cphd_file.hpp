#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/os/input_file.hpp"
#include "core/report/problem.hpp"
#include "core/task/stop.hpp"
#include "raster/cphd/block_file.hpp"
#include "raster/cphd/cphd_description.hpp"

namespace sarsim::raster {

/// A CPHD file, opened for reading (docs/formats/cphd.md): versions 1.0.1 and 1.1.0, FX and TOA, either sign, all
/// encodings, any number of channels, parameters at any places. May be read from many threads at once; memory does not
/// grow with the file.
class CphdFile {
 public:
  /// Reads header and XML and compares all sizes with that of the file. Dialects of vendors are accepted with a remark.
  /// Throws Interrupted where a stop is requested while the parameters of the vectors are looked through.
  /// @param[in,out] problems  gets errors, and then nothing is returned, or remarks
  [[nodiscard]] static std::shared_ptr<const CphdFile> open(core::InputFile file, core::Problems& problems,
                                                            const core::StopFlag* stop = nullptr);

  [[nodiscard]] const CphdDescription& description() const { return description_; }
  [[nodiscard]] const core::InputFile& file() const { return file_; }
  /// Number of the channel of that name; nothing where there is none. An empty name means the reference channel.
  [[nodiscard]] std::optional<std::size_t> channel_of(std::string_view id) const;

  /// The parameters of the vectors [first, first + out.size()) of a channel. std::runtime_error where the file has
  /// become shorter.
  void read_vectors(std::size_t channel, std::size_t first, std::span<PhaseVector> out) const;
  /// The samples of a vector as volts or whatever unit they have, AmpSF taken into account.
  /// @param amplitude  `PhaseVector::amplitude` of the vector
  void read_samples(std::size_t channel, std::size_t vector, double amplitude,
                    std::span<std::complex<float>> out) const;

 private:
  explicit CphdFile(core::InputFile file) : file_(std::move(file)) {}

  core::InputFile file_;
  CphdDescription description_;
  std::vector<PvpSlot> slots_;
  FileBlock pvp_;
  FileBlock signal_;
};

/// What the XML of a CPHD file says, and where the parameters stand in a vector; errors or remarks join `problems`.
/// Throws nothing.
/// @param file  its name, for the problems
[[nodiscard]] std::optional<std::pair<CphdDescription, std::vector<PvpSlot>>> read_cphd_xml(std::string_view xml,
                                                                                            const std::string& file,
                                                                                            core::Problems& problems);

}  // namespace sarsim::raster
