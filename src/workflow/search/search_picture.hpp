#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "signal/search/ppi.hpp"
#include "workflow/search/detection_table.hpp"
#include "workflow/search/search_intervals.hpp"

namespace sarsim::workflow {

/// Part of the ground that a picture shows.
struct PictureArguments {
  std::optional<double> pixel_m{};
  std::optional<double> extent_m{};
  std::optional<double> height_m{};   ///< World z of the plane that ranges are projected to; default 0.
  std::optional<std::size_t> scan{};  ///< Turn of the antenna, from 0; default: all.
};

/// Distance on a plane `height_m` below the antenna of what lies at a slant range; 0 for what is nearer than the plane.
[[nodiscard]] double ground_range_m(double slant_m, double height_m);

/// The grid of a picture: about where the radar is in the middle of the recording, as far as the recorded ranges reach,
/// unless the arguments say otherwise; pixels of a range sample, or of a thousandth of the reach where that is more.
/// Throws core::InvalidRequest for arguments that make no sense.
[[nodiscard]] signal::PpiGrid picture_grid(const PulseRows& rows, const PictureArguments& arguments);

/// Whole and begun turns that the beam makes over all pulses; 1 where it does not turn.
[[nodiscard]] double turns_of_beam(const PulseRows& rows);

/// The same before anything is computed: a rotating antenna says how often it turns, others are followed from pulse to
/// pulse.
[[nodiscard]] double turns_to_come(const PulseRows& rows);

/// Where a detection lies on the plane of that height, in the direction of the beam.
[[nodiscard]] GroundPlace place_of(const SearchInterval& interval, const SearchDetection& detection, double height_m);

/// Paints intervals as they come: each is a line whose strength is the largest over its Doppler frequencies, and whose
/// sector reaches half way to its neighbours. A beam that stands still is as wide as it is.
class SearchPicture {
 public:
  /// Keeps a reference to the rows.
  SearchPicture(const PulseRows& rows, const PictureArguments& arguments);

  /// Paints the interval before this one, whose sector is known now.
  void take(const SearchInterval& interval);
  /// Paints the last interval.
  void finish();

  [[nodiscard]] const signal::PpiPicture& picture() const { return picture_; }
  /// Lines painted.
  [[nodiscard]] std::size_t lines() const { return lines_; }
  /// Whole and begun turns that the antenna made.
  [[nodiscard]] std::size_t scans() const;

 private:
  // A line that waits for its neighbour.
  struct Line {
    double x_m = 0.0;
    double y_m = 0.0;
    double azimuth_rad = 0.0;  // not wrapped
    std::vector<double> edges_m;
    std::vector<float> strengths;
  };
  [[nodiscard]] Line line_of(const SearchInterval& interval) const;
  void paint(const Line& line, double before_rad, double after_rad);

  const PulseRows& rows_;
  double height_m_;
  double still_rad_;  // width of a beam that does not turn
  std::optional<std::size_t> scan_;
  signal::PpiPicture picture_;
  std::optional<Line> waiting_;
  double first_azimuth_rad_ = 0.0;
  double before_rad_ = 0.0;  // from the waiting line to the one before
  std::size_t lines_ = 0;
  double farthest_turn_rad_ = 0.0;
};

}  // namespace sarsim::workflow
