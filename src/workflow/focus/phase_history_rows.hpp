#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"
#include "radar/earth/earth_frame.hpp"
#include "raster/cphd/cphd_file.hpp"
#include "signal/sar/sar_echoes.hpp"

namespace sarsim::workflow {

/// A channel of a CPHD file for back projection: some vectors at a time become compressed echoes, so that memory does
/// not grow with the file.
class PhaseHistoryRows {
 public:
  /// @param sign    of the phase, where that of the file is wrong
  /// @param earth   under the world in which echoes are wanted
  PhaseHistoryRows(std::shared_ptr<const raster::CphdFile> file, std::size_t channel, std::optional<int> sign,
                   const radar::EarthFrame& earth);

  [[nodiscard]] const raster::PhaseChannel& channel() const { return file_->description().channels[channel_]; }
  /// How many vectors from `first` on can be made into echoes together: those with the same sampling, and no more than
  /// fit into some 64 MB.
  [[nodiscard]] std::size_t together(std::size_t first) const;
  /// The echoes of vectors [first, first + count), without those that have no signal: compressed about the reference
  /// point of each vector, whose light time is that of an antenna that flies on or, bistatic, the sum of both ways.
  /// @throws core::InvalidRequest for samples that are no numbers; core::Interrupted
  [[nodiscard]] signal::SarEchoes echoes(std::size_t first, std::size_t count, const core::WorkControl& control) const;
  /// Vectors, evenly chosen, at most so many; those without a signal are left out.
  [[nodiscard]] std::vector<raster::PhaseVector> some_vectors(std::size_t most) const;
  /// Where and how an antenna was, world: while the echo is under way, where transmitter and receiver are one.
  [[nodiscard]] signal::TrackPoint track_point(const raster::PhaseVector& vector) const;
  /// Middle frequency of the samples of a vector, to which the phase of its echoes is referred.
  [[nodiscard]] double carrier_hz(const raster::PhaseVector& vector) const;

 private:
  struct Sampling;
  [[nodiscard]] Sampling sampling_of(const raster::PhaseVector& vector) const;
  [[nodiscard]] double reference_delay_s(const raster::PhaseVector& vector, const signal::TrackPoint& point) const;

  std::shared_ptr<const raster::CphdFile> file_;
  std::size_t channel_;
  int sign_;
  radar::EarthFrame earth_;
};

}  // namespace sarsim::workflow
