#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "picture/echo/radar_views.hpp"
#include "picture/figure/figure.hpp"

/// The views of radar engineers as figures.
namespace sarsim::picture {

/// What is looked at.
enum class RadarView {
  range_profile,  ///< Mean over a burst of pulses against range.
  range_doppler,  ///< Map of a coherent interval, with the Doppler spectrum of one range cell below.
  doppler_time,   ///< Map of the Doppler spectra of one range cell against time, with their middle and width below.
  spectrum,       ///< Of one pulse.
  phase_history,  ///< Of one range cell, with the change of range that it means below.
};

/// "Range profile", "Range-Doppler map", "Doppler against time", "Spectrum of the pulse", "Phase history".
[[nodiscard]] std::string_view title_of(RadarView view);

inline constexpr std::size_t usual_doppler_interval = 64;

/// The choices of a view and the place that it belongs to.
struct RadarViewChoice {
  RadarView view = RadarView::range_profile;
  double range_m = 0.0;                           ///< Of the cursor.
  double time_s = 0.0;                            ///< Of the cursor.
  std::size_t pulses = 64;                        ///< About the cursor, at least 1: the burst or coherent interval.
  std::size_t interval = usual_doppler_interval;  ///< Pulses of each spectrum of Doppler against time.
  ProfileMean mean = ProfileMean::power;          ///< Of the range profile.
  SpectrumWindow window = SpectrumWindow::hann;   ///< Of both spectra.
  std::size_t padding = 1;                        ///< Doppler bins for each pulse, at least 1.
  bool decibels = true;                           ///< Of profile and spectrum.
  bool unwrapped = true;                          ///< Of the phase.
  double range_db = 60.0;                         ///< Of the map's colours, below its largest value.

  friend bool operator==(const RadarViewChoice&, const RadarViewChoice&) = default;
};

/// Rows and columns of a recording that a choice means.
struct RadarViewPlace {
  std::size_t row = 0;       ///< Sent nearest to the cursor's time.
  std::size_t column = 0;    ///< Nearest to its range.
  simulate::IndexSpan rows;  ///< As many as chosen about `row`, moved so that they are in the recording.
};
[[nodiscard]] RadarViewPlace place_of(const simulate::Acquisition& acquisition, const RadarViewChoice& choice);

/// Computes the samples of a view and draws it as a figure; what is not as the view supposes is in its note.
/// @throws Interrupted when stopped; std::runtime_error with what to do where it would take more than 2^25 samples
[[nodiscard]] Figure radar_figure(const simulate::Plan& plan, const RadarViewChoice& choice,
                                  const core::WorkControl& control = {});

/// The figures of samples that are there. `row` and `column` belong to the block.
/// @{
[[nodiscard]] Figure range_profile_figure(const EchoBlock& block, const RadarViewChoice& choice);
[[nodiscard]] Figure range_doppler_figure(const EchoBlock& block, std::size_t column, const RadarViewChoice& choice);
[[nodiscard]] Figure doppler_time_figure(const EchoBlock& block, std::size_t column, const RadarViewChoice& choice);
[[nodiscard]] Figure spectrum_figure(const EchoBlock& block, std::size_t row, const RadarViewChoice& choice);
[[nodiscard]] Figure phase_figure(const EchoBlock& block, std::size_t column, const RadarViewChoice& choice);
/// @}

/// The curves of a figure as text for a spreadsheet: for each panel a header line with names and units, then a line for
/// each point; an empty line between panels. Curves over the same places share their lines. What is no finite number
/// is left empty.
[[nodiscard]] std::string curves_table(const Figure& figure, char separator);

}  // namespace sarsim::picture
