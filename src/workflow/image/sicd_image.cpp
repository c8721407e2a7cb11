#include "workflow/image/sicd_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "raster/table/product_attributes.hpp"
#include "signal/measure/response.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/image/map_fields.hpp"
#include "workflow/image/polynomial_surface.hpp"

namespace sarsim::workflow {

namespace {

core::Vec3 unit_of(const core::Vec3& vector) { return (1.0 / core::norm(vector)) * vector; }

// Parameters of the collection that fields of a header become, and which way columns count.
const std::string parameter_prefix = "sarsim ";
constexpr const char* columns_parameter = "sarsim columns";
constexpr const char* with_flight = "in the direction of flight";
constexpr const char* against_flight = "against the direction of flight";

double last_index(const signal::ImageAxis& axis) { return static_cast<double>(axis.count) - 1.0; }

double turns_per_m_of(const signal::FocusedImage& image) {
  return radar::turns_per_m(image.carrier_hz, image.light_speed_mps);
}

// How much of the way from the side towards the middle an index is taken: 0, 1/2 and 1 of three.
double spread(std::size_t i, std::size_t count, const signal::ImageAxis& axis) {
  return axis.at(last_index(axis) * static_cast<double>(i) / static_cast<double>(count - 1));
}

// Everything that the parts of a description are made from. Times count from the first pulse.
class SicdMaker {
 public:
  SicdMaker(const signal::FocusedImage& image, const ImageOrigin& origin, const ImageCollection& collection)
      : image_(image),
        origin_(origin),
        collection_(collection),
        track_(signal::fit_straight(collection.track)),
        ground_(image.frame.plane == signal::ImagePlane::ground_grid) {
    choose_reference();
    make_positions();
    const core::Vec3 sight = reference_m_ - line_at(reference_.azimuth_m);
    const raster::SicdView view = view_at(closest_time(reference_.azimuth_m));
    side_ = view.left ? -1.0 : 1.0;
    row_axis_ = ground_ ? image.frame.across : unit_of(sight);
    column_axis_ = side_ * image.frame.along;
    if (!ground_ || core::dot(core::cross(row_axis_, column_axis_), up()) > 0.0) return;
    side_ = -side_;  // Of a ground grid whose columns were chosen for the other side.
    column_axis_ = -column_axis_;
  }

  SicdImage made(const raster::EnviHeader& header, const std::string& name) {
    raster::Sicd sicd;
    sicd.collector = origin_.radar.empty() ? "SARSIM" : origin_.radar;
    sicd.name = name.empty() ? "image" : name;
    sicd.application = fmt::format("sarsim {}", core::program_version);
    sicd.parameters = parameters(header);
    sicd.rows = image_.range.count;
    sicd.columns = image_.azimuth.count;
    sicd.reference_row = reference_row_;
    sicd.reference_column = side_ < 0.0 ? image_.azimuth.count - 1 - reference_line_ : reference_line_;
    sicd.reference_ecf_m = collection_.earth.ecef_from_world(reference_m_);
    sicd.corners = corners();
    sicd.ground = ground_;
    sicd.position_ecf_m = positions_;
    sicd.lowest_hz = collection_.lowest_hz;
    sicd.highest_hz = collection_.highest_hz;
    sicd.autofocused = collection_.autofocused;
    sicd.processing = processing();
    set_times(sicd);
    set_waveform(sicd);
    set_directions(sicd);
    sicd.view = view_at(sicd.time_s[0][0]);
    return {std::move(sicd), side_ < 0.0};
  }

 private:
  [[nodiscard]] double first_s() const { return collection_.track.front().time_s; }
  [[nodiscard]] core::Vec3 line_at(double azimuth_m) const {
    return image_.frame.origin_m + azimuth_m * image_.frame.along;
  }

  // The line that an image of ranges counts from. A ground grid has a level frame, and its line is that of the track.
  [[nodiscard]] core::Vec3 foot_of(const core::Vec3& point_m) const {
    return track_.origin_m + core::dot(point_m - track_.origin_m, track_.along) * track_.along;
  }

  // When the antenna of the line is at its foot of a point.
  [[nodiscard]] double time_at_foot(const core::Vec3& point_m) const {
    const double middle_s = collection_.track[track_.middle_pulse].time_s - first_s();
    return middle_s + core::dot(point_m - track_.origin_m, track_.along) / track_.speed_mps;
  }
  [[nodiscard]] double closest_time(double azimuth_m) const { return time_at_foot(line_at(azimuth_m)); }

  [[nodiscard]] std::optional<core::Vec3> point_at(const signal::ImagePlace& place) const {
    return ground_point(image_, collection_.earth, collection_.scene_m, place);
  }

  [[nodiscard]] core::Vec3 up() const {
    const core::Mat3 axes = collection_.earth.world_from_enu(collection_.earth.geodetic_of(reference_m_));
    return {axes.row[0].z, axes.row[1].z, axes.row[2].z};
  }

  // The pixel in the middle, or, where its range does not reach the ground, the nearest one farther away that does.
  void choose_reference() {
    reference_line_ = image_.azimuth.count / 2;
    for (reference_row_ = image_.range.count / 2; reference_row_ < image_.range.count; ++reference_row_) {
      reference_ = {image_.azimuth.at(static_cast<double>(reference_line_)),
                    image_.range.at(static_cast<double>(reference_row_))};
      if (const auto point = point_at(reference_)) {
        reference_m_ = *point;
        return;
      }
    }
    throw core::InvalidRequest("SICD: no range of the image reaches the ground, at the height of the scene's middle",
                               "give the ground another --height, or name the output .img");
  }

  // Of a slant image the line that its ranges and azimuths are counted from; of a ground grid, whose echoes keep the
  // true flight, a polynomial through that.
  void make_positions() {
    std::vector<core::Vec3> terms;
    if (!ground_) {
      const core::Vec3 velocity = image_.frame.speed_mps * image_.frame.along;
      terms = {line_at(0.0) - closest_time(0.0) * velocity, velocity};
    } else {
      terms = flight_terms();
    }
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const core::Vec3 ecf =
          i == 0 ? collection_.earth.ecef_from_world(terms[i]) : collection_.earth.ecef_axes_from_world(terms[i]);
      positions_[0].push_back(ecf.x);
      positions_[1].push_back(ecf.y);
      positions_[2].push_back(ecf.z);
    }
  }

  // The lowest degree that follows the flight to a tenth of a millimetre, at most 7.
  [[nodiscard]] std::vector<core::Vec3> flight_terms() const {
    constexpr std::size_t max_degree = 7;
    constexpr double good_m = 1e-4;
    constexpr std::size_t max_points = 512;
    const std::size_t step = std::max<std::size_t>(1, collection_.track.size() / max_points);
    const core::Vec3 from = collection_.track.front().position_m;
    std::array<std::vector<SurfacePoint>, 3> points;
    for (std::size_t p = 0; p < collection_.track.size(); p += step) {
      const signal::TrackPoint& at = collection_.track[p];
      const core::Vec3 way = at.position_m - from;
      points[0].push_back({at.time_s - first_s(), 0.0, way.x});
      points[1].push_back({at.time_s - first_s(), 0.0, way.y});
      points[2].push_back({at.time_s - first_s(), 0.0, way.z});
    }
    std::vector<core::Vec3> terms;
    for (std::size_t degree = 1; degree <= max_degree; ++degree) {
      std::array<std::vector<std::vector<double>>, 3> axes;
      double worst_m = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        axes[axis] = polynomial_surface(points[axis], degree, 0);
        for (const SurfacePoint& point : points[axis])
          worst_m = std::max(worst_m, std::abs(surface_value(axes[axis], point.x, 0.0) - point.value));
      }
      terms.clear();
      for (std::size_t i = 0; i <= degree; ++i) terms.push_back({axes[0][i][0], axes[1][i][0], axes[2][i][0]});
      if (worst_m < good_m) break;
    }
    terms.front() = from + terms.front();
    return terms;
  }

  [[nodiscard]] std::array<core::Vec3, 3> state_at(double time_s) const {
    std::array<std::array<double, 3>, 3> state{};  // of derivatives, of axes
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = positions_[axis].size(); i-- > 0;) {
        state[2][axis] = state[2][axis] * time_s + 2.0 * state[1][axis];
        state[1][axis] = state[1][axis] * time_s + state[0][axis];
        state[0][axis] = state[0][axis] * time_s + positions_[axis][i];
      }
    const auto vector = [](const std::array<double, 3>& v) { return core::Vec3{v[0], v[1], v[2]}; };
    return {vector(state[0]), vector(state[1]), vector(state[2])};
  }

  [[nodiscard]] raster::SicdView view_at(double time_s) const {
    return raster::sicd_view(time_s, state_at(time_s), collection_.earth.ecef_from_world(reference_m_));
  }

  // A place of the edge of the image, as far towards its near side as the ground is reached.
  [[nodiscard]] core::Vec3 reached_point(signal::ImagePlace place) const {
    if (const auto point = point_at(place)) return *point;
    double reached_m = reference_.range_m;
    double beyond_m = place.range_m;
    for (int halving = 0; halving < 50; ++halving) {
      const double middle_m = 0.5 * (reached_m + beyond_m);
      (point_at({place.azimuth_m, middle_m}) ? reached_m : beyond_m) = middle_m;
    }
    return point_at({place.azimuth_m, reached_m}).value_or(reference_m_);
  }

  [[nodiscard]] std::array<radar::Geodetic, 4> corners() const {
    const double first_m = image_.azimuth.at(side_ < 0.0 ? last_index(image_.azimuth) : 0.0);
    const double last_m = image_.azimuth.at(side_ < 0.0 ? 0.0 : last_index(image_.azimuth));
    const double near_m = image_.range.at(0.0);
    const double far_m = image_.range.at(last_index(image_.range));
    const std::array<signal::ImagePlace, 4> places{
        {{first_m, near_m}, {last_m, near_m}, {last_m, far_m}, {first_m, far_m}}};
    std::array<radar::Geodetic, 4> corners;
    for (std::size_t i = 0; i < places.size(); ++i)
      corners[i] = collection_.earth.geodetic_of(reached_point(places[i]));
    return corners;
  }

  [[nodiscard]] std::vector<std::pair<std::string, std::string>> parameters(const raster::EnviHeader& header) const {
    std::vector<std::pair<std::string, std::string>> found;
    for (const auto& [name, value] : header.fields) found.emplace_back(parameter_prefix + name, value);
    found.emplace_back(columns_parameter, side_ < 0.0 ? against_flight : with_flight);
    return found;
  }

  [[nodiscard]] std::string processing() const {
    return fmt::format("{}, motion compensation: {}, range window: {}, azimuth window: {}", origin_.algorithm,
                       origin_.motion, signal::to_string(origin_.options.range_window),
                       signal::to_string(origin_.options.azimuth_window));
  }

  void set_times(raster::Sicd& sicd) const {
    const auto pulses = static_cast<double>(collection_.track.size());
    sicd.start = radar::format_instant(radar::later(collection_.epoch, first_s()), radar::TimeScale::utc, 9);
    const double span_s = collection_.track.back().time_s - first_s();
    sicd.duration_s = span_s * pulses / (pulses - 1.0);
    constexpr double even = 0.01;
    if (track_.worst_interval_s < even * track_.interval_s) sicd.pulses = collection_.track.size();
    sicd.window_s = collection_.window_s;
  }

  void set_waveform(raster::Sicd& sicd) const {
    const signal::SarWaveform& waveform = collection_.waveform;
    sicd.sample_rate_hz = waveform.sample_rate_hz;
    const double sent_hz = collection_.highest_hz - collection_.lowest_hz;
    // Of one carrier, and a chirp.
    if (!(waveform.pulse_width_s > 0.0) || std::abs(sent_hz - std::abs(waveform.bandwidth_hz)) > 1e-3 * sent_hz) return;
    sicd.pulse_width_s = waveform.pulse_width_s;
    sicd.chirp_rate_hz_per_s = waveform.bandwidth_hz / waveform.pulse_width_s;
  }

  // ----- When points were seen, and which wave numbers they have -----

  // Steps of time with place, seen along the track in the middle of the image: 0 of a spotlight, 1 over the speed of a
  // fixed beam.
  [[nodiscard]] double slope_of_times() const {
    const std::size_t middle = (seen_across / 2) * seen_along + seen_along / 2;
    const SeenPlace& before = collection_.seen[middle - 1];
    const SeenPlace& behind = collection_.seen[middle + 1];
    const double way_m = behind.place.azimuth_m - before.place.azimuth_m;
    return way_m > 0.0 ? (behind.time_s - before.time_s) / way_m * image_.frame.speed_mps : 0.0;
  }

  [[nodiscard]] double sine_of_centroid() const {
    const double most = 0.999;
    return std::clamp(origin_.options.doppler_centroid_hz / (turns_per_m_of(image_) * image_.frame.speed_mps), -most,
                      most);
  }

  // Coordinates of a place in the file, from the reference point.
  [[nodiscard]] double x_of(const signal::ImagePlace& place) const { return place.range_m - reference_.range_m; }
  [[nodiscard]] double y_of(const signal::ImagePlace& place) const {
    return side_ * (place.azimuth_m - reference_.azimuth_m);
  }

  // The distance of a place from the line of flight.
  [[nodiscard]] double distance_of(const signal::ImagePlace& place) const {
    if (!ground_) return place.range_m;
    const core::Vec3 point = point_of_place(place);
    return core::norm(point - foot_of(point));
  }
  [[nodiscard]] core::Vec3 point_of_place(const signal::ImagePlace& place) const {
    return line_at(place.azimuth_m) + place.range_m * image_.frame.across;
  }
  // When a place of the image lies straight beside the antenna.
  [[nodiscard]] double closest_time(const signal::ImagePlace& place) const {
    return ground_ ? time_at_foot(point_of_place(place)) : closest_time(place.azimuth_m);
  }

  using Surface = raster::Polynomial2;

  template <class Value>
  [[nodiscard]] Surface surface_of(std::size_t degree_x, std::size_t degree_y, const Value& value) const {
    std::vector<SurfacePoint> points;
    constexpr std::size_t across = 7;
    constexpr std::size_t along = 13;
    for (std::size_t i = 0; i < across; ++i)
      for (std::size_t j = 0; j < along; ++j) {
        const signal::ImagePlace place{spread(j, along, image_.azimuth), spread(i, across, image_.range)};
        points.push_back({x_of(place), y_of(place), value(place)});
      }
    return polynomial_surface(points, degree_x, degree_y);
  }

  // When the middle of the aperture sees each place.
  [[nodiscard]] Surface times_of_middle(std::string& mode) const {
    constexpr double spotlight = 0.1;
    constexpr double fixed = 0.75;
    const double slope = slope_of_times();
    if (slope < spotlight) {
      mode = "SPOTLIGHT";
      return {{collection_.seen[(seen_across / 2) * seen_along + seen_along / 2].time_s - first_s()}};
    }
    if (slope > fixed) {
      mode = "STRIPMAP";
      const double tangent = sine_of_centroid() / std::sqrt(1.0 - sine_of_centroid() * sine_of_centroid());
      return surface_of(ground_ ? 3 : 1, 1, [&](const signal::ImagePlace& place) {
        return closest_time(place) - distance_of(place) * tangent / track_.speed_mps;
      });
    }
    mode = "DYNAMIC STRIPMAP";
    std::vector<SurfacePoint> points;
    for (const SeenPlace& seen : collection_.seen)
      points.push_back({x_of(seen.place), y_of(seen.place), seen.time_s - first_s()});
    return polynomial_surface(points, 1, 1);
  }

  // The sine of the angle by which a point is seen ahead at its middle time.
  [[nodiscard]] double sine_at(const Surface& times, const signal::ImagePlace& place) const {
    const double ahead_m = track_.speed_mps * (closest_time(place) - surface_value(times, x_of(place), y_of(place)));
    return ahead_m / std::hypot(distance_of(place), ahead_m);
  }

  // Wave numbers of a ground grid: those of the line of sight less those of the closest approach, which the image's
  // phase has (signal/sar/back_projection.hpp).
  [[nodiscard]] double wave_number(const Surface& times, const signal::ImagePlace& place,
                                   const core::Vec3& axis) const {
    const core::Vec3 point = point_of_place(place);
    const core::Vec3 antenna =
        collection_.earth.world_from_ecef(state_at(surface_value(times, x_of(place), y_of(place)))[0]);
    const core::Vec3 way = unit_of(point - antenna) - unit_of(point - foot_of(point));
    return turns_per_m_of(image_) * core::dot(way, axis);
  }

  void set_directions(raster::Sicd& sicd) {
    const double per_m = turns_per_m_of(image_);
    sicd.time_s = times_of_middle(sicd.mode);
    raster::SicdDirection& row = sicd.row;
    raster::SicdDirection& column = sicd.column;
    row.step_m = image_.range.step_m;
    column.step_m = image_.azimuth.step_m;
    row.unit_ecf = collection_.earth.ecef_axes_from_world(row_axis_);
    column.unit_ecf = collection_.earth.ecef_axes_from_world(column_axis_);
    const core::Vec3 nearest = unit_of(reference_m_ - foot_of(reference_m_));
    const double lying = ground_ ? std::abs(core::dot(nearest, row_axis_)) : 1.0;
    row.centre_per_m = ground_ ? per_m * core::dot(nearest, row_axis_) : per_m;
    row.bandwidth_per_m = std::min(collection_.range_bandwidth_per_m * lying, 1.0 / row.step_m);
    column.bandwidth_per_m = std::min(collection_.azimuth_bandwidth_per_m, 1.0 / column.step_m);
    if (ground_) {
      row.offset_per_m =
          surface_of(2, 2, [&](const auto& place) { return wave_number(sicd.time_s, place, row_axis_); });
      column.offset_per_m =
          surface_of(2, 3, [&](const auto& place) { return wave_number(sicd.time_s, place, column_axis_); });
    } else {
      set_approach(sicd);
    }
    set_window(row, origin_.options.range_window);
    set_window(column, origin_.options.azimuth_window);
    set_extent(row);
    set_extent(column);
  }

  void set_approach(raster::Sicd& sicd) const {
    const double per_m = turns_per_m_of(image_);
    const bool fixed = sicd.mode == "STRIPMAP";
    const std::size_t degree_x = fixed ? 0 : 2;
    const std::size_t degree_y = fixed ? 0 : 3;
    raster::SicdClosestApproach approach;
    approach.algorithm = origin_.algorithm == "omega-k"         ? "OMEGA_K"
                         : origin_.algorithm == "chirp-scaling" ? "CSA"
                                                                : "RG_DOP";
    approach.time_s = {closest_time(reference_.azimuth_m), side_ / image_.frame.speed_mps};
    approach.range_m = reference_.range_m;
    approach.carrier_hz = image_.carrier_hz;
    approach.rate_factor = {{1.0}};
    const Surface centroids_hz = surface_of(degree_x, degree_y, [&](const auto& place) {
      return per_m * image_.frame.speed_mps * sine_at(sicd.time_s, place);
    });
    sicd.column.offset_per_m = centroids_hz;
    for (auto& terms : sicd.column.offset_per_m)
      for (double& term : terms) term *= approach.time_s[1];
    sicd.row.offset_per_m = surface_of(degree_x, fixed ? 0 : 2, [&](const auto& place) {
      const double sine = sine_at(sicd.time_s, place);
      return per_m * (std::sqrt(1.0 - sine * sine) - 1.0);
    });
    if (sicd.mode != "SPOTLIGHT") approach.centroid_hz = centroids_hz;
    sicd.approach = std::move(approach);
  }

  static void set_window(raster::SicdDirection& direction, const signal::SarWindow& window) {
    using Kind = signal::SarWindow::Kind;
    if (window.kind == Kind::rectangular) {
      direction.width_m = signal::even_response_width / direction.bandwidth_per_m;
      return;
    }
    direction.width_m = signal::theoretical_figures(window).width / direction.bandwidth_per_m;
    switch (window.kind) {
      case Kind::hamming: direction.window = "HAMMING"; break;
      case Kind::bartlett: direction.window = "BARTLETT"; break;
      case Kind::blackman: direction.window = "BLACKMAN"; break;
      case Kind::hann: direction.window = "HANNING"; break;
      case Kind::kaiser:
        direction.window = "KAISER";
        direction.window_parameters = {{"BETA", core::format_number(window.beta)}};
        break;
      case Kind::taylor:
        direction.window = "TAYLOR";
        direction.window_parameters = {{"NBAR", fmt::format("{}", window.equal_sidelobes)},
                                       {"SLL", core::format_number(-window.sidelobes_db)}};
        break;
      case Kind::rectangular: break;
    }
    constexpr std::size_t samples = 512;
    const auto weight = signal::weight_of(window);
    double largest = 0.0;
    for (std::size_t i = 0; i < samples; ++i) {
      direction.weights.push_back(weight((static_cast<double>(i) + 0.5) / samples - 0.5));
      largest = std::max(largest, direction.weights.back());
    }
    for (double& one : direction.weights) one /= largest;
  }

  // Over the corners of the image; a spectrum that reaches beyond half the sampling rate wraps, and fills all of it.
  void set_extent(raster::SicdDirection& direction) const {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const double azimuth_m : {image_.azimuth.at(0.0), image_.azimuth.at(last_index(image_.azimuth))})
      for (const double range_m : {image_.range.at(0.0), image_.range.at(last_index(image_.range))}) {
        const signal::ImagePlace place{azimuth_m, range_m};
        const double offset = surface_value(direction.offset_per_m, x_of(place), y_of(place));
        least = std::min(least, offset - 0.5 * direction.bandwidth_per_m);
        most = std::max(most, offset + 0.5 * direction.bandwidth_per_m);
      }
    const double half = 0.5 / direction.step_m;
    const bool wraps = least < -half || most > half;
    direction.min_per_m = wraps ? -half : least;
    direction.max_per_m = wraps ? half : most;
  }

  const signal::FocusedImage& image_;
  const ImageOrigin& origin_;
  const ImageCollection& collection_;
  signal::StraightTrack track_;
  bool ground_;
  std::size_t reference_row_ = 0;   // a range
  std::size_t reference_line_ = 0;  // a place along the track
  signal::ImagePlace reference_;
  core::Vec3 reference_m_;
  double side_ = 1.0;  // -1: columns count against the flight
  core::Vec3 row_axis_;
  core::Vec3 column_axis_;
  std::array<raster::Polynomial, 3> positions_;
};

// Turns the point about the line of flight, at its range, until it has the height.
std::optional<core::Vec3> point_of_height(const radar::EarthFrame& earth, const core::Vec3& foot_m,
                                          const core::Vec3& along, const core::Vec3& scene_m, double range_m) {
  constexpr int max_steps = 50;
  constexpr double good_m = 1e-7;
  const core::Vec3 to_scene = scene_m - foot_m;
  const core::Vec3 across = to_scene - core::dot(to_scene, along) * along;
  if (!(core::norm(across) > 0.0) || !(range_m > 0.0)) return std::nullopt;
  const core::Vec3 side = unit_of(across);
  const core::Vec3 turned = core::cross(along, side);
  const double height_m = earth.geodetic_of(scene_m).height_m;
  double angle = 0.0;
  for (int step = 0; step < max_steps; ++step) {
    const core::Vec3 point = foot_m + range_m * (std::cos(angle) * side + std::sin(angle) * turned);
    const radar::Geodetic place = earth.geodetic_of(point);
    const double above_m = place.height_m - height_m;
    if (std::abs(above_m) < good_m) return point;
    const core::Mat3 axes = earth.world_from_enu(place);
    const core::Vec3 up{axes.row[0].z, axes.row[1].z, axes.row[2].z};
    const double slope_m = range_m * core::dot(up, -std::sin(angle) * side + std::cos(angle) * turned);
    if (std::abs(slope_m) < 1e-9 * range_m) return std::nullopt;
    constexpr double max_turn = 0.3;
    angle -= std::clamp(above_m / slope_m, -max_turn, max_turn);
    constexpr double half_turn = 1.5707963267948966;
    if (!(std::abs(angle) < half_turn)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<signal::ImagePlace> places_to_look_at(const signal::FocusedImage& image) {
  std::vector<signal::ImagePlace> places;
  for (std::size_t i = 0; i < seen_across; ++i)
    for (std::size_t j = 0; j < seen_along; ++j)
      places.push_back({spread(j, seen_along, image.azimuth), spread(i, seen_across, image.range)});
  return places;
}

std::optional<core::Vec3> ground_point(const signal::FocusedImage& image, const radar::EarthFrame& earth,
                                       const core::Vec3& scene_m, const signal::ImagePlace& place) {
  const core::Vec3 foot_m = image.frame.origin_m + place.azimuth_m * image.frame.along;
  if (image.frame.plane == signal::ImagePlane::ground_grid) return foot_m + place.range_m * image.frame.across;
  return point_of_height(earth, foot_m, image.frame.along, scene_m, place.range_m);
}

SicdImage sicd_of(const signal::FocusedImage& image, const ImageOrigin& origin, const ImageCollection& collection,
                  const raster::EnviHeader& header, const std::string& name) {
  if (is_of_turning_target(origin))
    throw core::InvalidRequest("SICD has no place for images of turning targets", "name the output .img");
  return SicdMaker(image, origin, collection).made(header, name);
}

std::optional<SicdSource> sicd_source(const raster::Raster& file) {
  SicdSource source;
  const raster::FileAttributes& attributes = file.info().attributes;
  const std::string columns = raster::attribute_of(attributes, columns_parameter);
  if (file.info().format != &raster::sicd_format() || columns.empty()) return std::nullopt;
  source.backwards = columns == against_flight;
  source.header.samples = file.rows();
  source.header.lines = file.columns();
  for (const auto& [name, value] : attributes)
    if (name.starts_with(parameter_prefix) && name != columns_parameter)
      source.header.fields.emplace_back(name.substr(parameter_prefix.size()), value);
  return source;
}

}  // namespace sarsim::workflow
