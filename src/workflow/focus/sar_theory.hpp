#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "signal/measure/response.hpp"
#include "signal/sar/focusing.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

/// What the image of a target is by theory.
struct TargetTheory {
  std::size_t target = 0;  ///< Position in the scene's list, from 0.
  /// By its distance and Doppler frequency: a moving target R u/v beside where it is, at the peak of its blurred
  /// response; one behind an atmosphere, which focusing does not correct, by its delay farther away.
  signal::ImagePlace place{};
  /// Weighted mean of its echoes (docs/theory/focusing.md) over the pulses that are focused, where motion was
  /// compensated over the line; in a Doppler band over the time that sweeps it, of back projection over as much of that
  /// as was flown. As they are recorded, volts: with the receiver's gain over
  /// time, less where the end of a raw recording cuts them, 0 outside the recorded ranges.
  double amplitude = 0.0;
  /// Its echoes are never within the recorded ranges: `place` is where its image would be.
  bool unrecorded = false;
  /// -4 pi f0 R0/c, R0 that of its place, and what an atmosphere leaves besides moving it, in (-pi, pi].
  double phase_rad = 0.0;
  /// Of a target that moves the peak of the sum of its echoes, each with the phase by which its distance differs from
  /// that of a point at rest in its place, is the amplitude, and its widths are those of that sum; none in range where
  /// it walks through more than a quarter of a cell. Widths and nulls in metres, along the cuts that
  /// `signal::measure_point` makes through the image: from the part of the wave number plane filled by the pulses that
  /// see the target (signal/measure/aperture_response.hpp). Where that is a rectangle, range is the chirp's
  /// autocorrelation under the window, and under the radar's where the recording is compressed, and azimuth the sum
  /// over pulses of amplitude and weight times exp(2 pi j f x/V). Range is nothing for other pulses, where echoes are
  /// not recorded whole, and where the sampling rate is below a sixteenth of the bandwidth, azimuth where no first
  /// minimum is in it.
  std::optional<signal::ResponseFigures> range;
  std::optional<signal::ResponseFigures> azimuth;
  /// Centre of its spectrum along both axes, cycles per metre. A ground grid's header has that of its middle, from
  /// which it differs as the angle of incidence does. Nothing: that of the image.
  std::optional<signal::SpectrumCentre> centre{};
};

/// How many targets theory and measurements list: all, but no points of clouds that have more than 4096 together.
[[nodiscard]] std::size_t listed_targets(const simulate::ResolvedScene& scene);

/// Theory of every target that is listed for these options of focusing.
/// @param echoes       their waveform and track; no rows are read
/// @param time_domain  back projection, which knows each pulse's true Doppler frequency: no echoes are lost to ghosts
/// @throw  Interrupted
[[nodiscard]] std::vector<TargetTheory> theory_of_targets(const simulate::Acquisition& acquisition,
                                                          const signal::EchoRows& echoes,
                                                          const signal::FocusOptions& options, bool time_domain = false,
                                                          const core::WorkControl& control = {});

/// Echoes, and how an image was focused of them.
struct FocusedEchoes {
  const simulate::Acquisition& acquisition;
  const signal::EchoRows& echoes;  ///< As recorded, along their own track; no rows are read.
  const signal::FocusOptions& options;
  bool time_domain = false;  ///< Back projection.
  bool compensated = false;  ///< Their motion was.
};

/// The same as `theory_of_targets`, in the coordinates of an image, in slant range or on the ground: metres from its
/// origin, along the flight and in range. On the ground the directions are those from the antenna's true positions to
/// the place in the image, whatever the flight does.
/// @param image  axes and frame; no values
/// @throw  Interrupted
[[nodiscard]] std::vector<TargetTheory> theory_on_image(const FocusedEchoes& focused, const signal::FocusedImage& image,
                                                        const core::WorkControl& control);

}  // namespace sarsim::workflow
