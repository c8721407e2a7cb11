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

/// No sample is larger, in I or Q, as of recordings: sums over all of them stay within single precision.
inline constexpr double max_cphd_sample = 1e28;

/// Checks the parameters of every vector with a signal in a CPHD file, and compares them with the XML
/// (docs/formats/cphd.md).
///
/// Errors, one for each channel: parameters that are not finite or outside the range of any collection, bands and
/// swaths with exchanged ends, an echo that arrives before its pulse leaves, sample spacings that are not above 0 or
/// that resolve fewer times of arrival than the vector has, positions more than 12 km inside the Earth, two-way paths
/// that are three times as long or short as the echo took, and reference points more than 1e7 m from the image area.
/// Warnings, each once with its count: times that do not ascend, receive times that contradict the two-way path by a
/// tenth, velocities that contradict the positions, bands, swaths and flags that contradict the XML. Takes time linear
/// in the vectors and constant memory.
/// @param[in,out] problems  receives the findings
/// @param stop  asked now and then; a requested stop throws Interrupted
void check_vectors(const CphdFile& file, core::Problems& problems, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::raster
