#include "simulate/run/geometry_table.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "core/report/problem.hpp"
#include "core/text/csv.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "scene/model/world_frame.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

using Write = std::function<void(std::string_view)>;

// The pulses of a table and where everything stands at each of them.
class TablePulses {
 public:
  TablePulses(const scene::Scene& scene, const scene::GeometryTable& table, const core::StopFlag* stop)
      : resolved_(resolve(scene, {1, stop})),
        radar_(resolve_radar(scene, resolved_, radar_index(scene, table))),
        geometry_(resolved_, radar_),
        range_(radar_.repetition.pulses_in(table.time_start_s, table.time_end_s)),
        platforms_(scene.platforms.size()),
        stop_(stop) {}

  [[nodiscard]] radar::PulseRange range() const { return range_; }
  [[nodiscard]] std::size_t platforms() const { return platforms_; }
  [[nodiscard]] std::size_t targets() const { return resolved_.scatterers.targets(); }
  [[nodiscard]] const std::string& platform_name(std::size_t i) const { return resolved_.platforms[i].name; }
  [[nodiscard]] const PulseGeometry& geometry() const { return geometry_; }
  [[nodiscard]] double light_speed_mps() const { return resolved_.conventions.light_speed_mps; }
  /// The pose of any platform, also of one that carries nothing.
  [[nodiscard]] radar::Pose pose(std::size_t i) const {
    return resolved_.platforms[i].track.at(geometry_.send_time_s(), geometry_.pulse());
  }

  /// Calls `line` with the geometry set to each pulse in turn.
  template <class Line>
  void each(const Line& line) {
    for (std::int64_t pulse = range_.first; pulse <= range_.last; ++pulse) {
      end_if_wanted();
      geometry_.set_pulse(pulse);
      line();
    }
  }
  /// Calls `each_target` with the number of each target in turn; there may be millions.
  template <class Each>
  void each_target(const Each& each_target) const {
    constexpr std::size_t between_looks = 1U << 12U;
    for (std::size_t i = 0; i < targets(); ++i) {
      if (i % between_looks == 0) end_if_wanted();
      each_target(i);
    }
  }

 private:
  void end_if_wanted() const {
    if (stop_ != nullptr && stop_->requested()) throw core::Interrupted();
  }
  static std::size_t radar_index(const scene::Scene& scene, const scene::GeometryTable& table) {
    const std::size_t found = scene::find_radar(scene, table.radar);
    if (found == scene::not_found) throw std::invalid_argument("radar '" + table.radar + "' is not defined");
    return found;
  }

  ResolvedScene resolved_;
  Link radar_;
  PulseGeometry geometry_;
  radar::PulseRange range_;
  std::size_t platforms_;
  const core::StopFlag* stop_;
};

// Gathers text and passes it on in large pieces, so that a line of a million targets is never held whole.
class PieceWriter {
 public:
  explicit PieceWriter(const Write& write) : write_(write) {}

  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    if (text_.size() >= piece) flush();
  }
  void flush() {
    if (!text_.empty()) write_(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t piece = 1U << 16U;
  const Write& write_;
  std::string text_;
};

// --- Text -----------------------------------------------------------------------------------------------------------

constexpr int header_lines = 4;

// Line `line` of a heading over one column: three texts and a rule.
void put_heading(PieceWriter& out, int line, int width, const std::array<std::string_view, 3>& texts) {
  if (line < 3)
    out.put("{:^{}} ", texts[static_cast<std::size_t>(line)], width);
  else
    out.put("{:-<{}} ", "", width);
}

// The same over three columns of 10 that belong to a platform.
void put_platform_heading(PieceWriter& out, int line, std::string_view what, std::string_view unit,
                          const std::string& platform) {
  switch (line) {
    case 0: out.put("{:^32} ", what); return;
    case 1: out.put("{:^32} ", fmt::format("({:.20})", core::printable(platform))); return;
    case 2:
      for (const char axis : {'X', 'Y', 'Z'}) out.put("{:^10} ", fmt::format("{} ({})", axis, unit));
      return;
    default: out.put("{0:-<10} {0:-<10} {0:-<10} ", ""); return;
  }
}

void put_header_line(PieceWriter& out, int line, const TablePulses& pulses, int columns) {
  put_heading(out, line, 9, {"Pulse", "number", ""});
  if ((columns & geometry_time) != 0) put_heading(out, line, 12, {"Send time", "", "(s)"});
  if ((columns & geometry_frequency) != 0) put_heading(out, line, 12, {"Frequency", "", "(GHz)"});
  for (std::size_t i = 0; i < pulses.platforms(); ++i) {
    const std::string& name = pulses.platform_name(i);
    if ((columns & geometry_position) != 0) put_platform_heading(out, line, "Position of platform", "m", name);
    if ((columns & geometry_velocity) != 0) put_platform_heading(out, line, "Velocity of platform", "m/s", name);
    if ((columns & geometry_rotation) != 0) put_platform_heading(out, line, "Rotation of platform", "deg", name);
  }
  pulses.each_target([&](std::size_t i) {
    const std::string target = fmt::format("Target {}", i + 1);
    if ((columns & geometry_delay) != 0) put_heading(out, line, 17, {"Two-way delay", target, "(s)"});
    if ((columns & geometry_amplitude) != 0) put_heading(out, line, 17, {"Echo amplitude", target, "(V)"});
    if ((columns & geometry_speed) != 0) put_heading(out, line, 17, {"Radial speed", target, "(m/s)"});
  });
  out.put("\n");
}

// Adding 0 turns -0 into 0.
void put_number(PieceWriter& out, double value, int width, int digits, char separator) {
  out.put("{:>{}.{}G}{}", value + 0.0, width, digits, separator);
}

void put_three(PieceWriter& out, const core::Vec3& v, char separator) {
  for (const double value : {v.x, v.y, v.z}) put_number(out, value, 10, 4, separator);
}

core::Vec3 rotation_deg(const radar::Pose& pose) {
  return {core::deg_per_rad * pose.rotation_rad[0], core::deg_per_rad * pose.rotation_rad[1],
          core::deg_per_rad * pose.rotation_rad[2]};
}

void put_platforms(PieceWriter& out, const TablePulses& pulses, int columns, char separator) {
  if ((columns & (geometry_position | geometry_velocity | geometry_rotation)) == 0) return;
  for (std::size_t i = 0; i < pulses.platforms(); ++i) {
    const radar::Pose pose = pulses.pose(i);
    if ((columns & geometry_position) != 0) put_three(out, pose.position_world_m, separator);
    if ((columns & geometry_velocity) != 0) put_three(out, pose.velocity_world_mps, separator);
    if ((columns & geometry_rotation) != 0) put_three(out, rotation_deg(pose), separator);
  }
}

void put_targets(PieceWriter& out, const TablePulses& pulses, const scene::GeometryTable& table, char separator) {
  if ((table.columns & (geometry_delay | geometry_amplitude | geometry_speed)) == 0) return;
  pulses.each_target([&](std::size_t i) {
    const ScattererView view = pulses.geometry().view(i);
    const double range_m = radar::range_of(view.delay_s, pulses.light_speed_mps());
    const bool seen = range_m >= table.range_start_m && range_m <= table.range_end_m;
    const auto put = [&](int bit, double value, int digits) {
      if ((table.columns & bit) == 0) return;
      if (seen)
        put_number(out, value, 17, digits, separator);
      else
        out.put("{:>17}{}", "nan", separator);
    };
    put(geometry_delay, view.delay_s, 12);
    put(geometry_amplitude, std::abs(view.amplitude_sqrt_w), 12);
    put(geometry_speed, view.speed_mps, 11);
  });
}

// --- CSV ------------------------------------------------------------------------------------------------------------

// What a world adds to the columns.
struct WorldColumns {
  explicit WorldColumns(const scene::World& world)
      : earth(scene::earth_of(world)), epoch(scene::epoch_of(world).instant) {}

  std::optional<radar::EarthFrame> earth;
  std::optional<radar::Instant> epoch;
};

void put_csv_header(PieceWriter& out, const TablePulses& pulses, const WorldColumns& world) {
  out.put("pulse,time_s{},carrier_hz", world.epoch ? ",utc" : "");
  for (std::size_t i = 0; i < pulses.platforms(); ++i) {
    const auto put = [&](std::initializer_list<const char*> quantities) {
      for (const char* quantity : quantities)
        out.put(",{}", core::csv_cell(fmt::format("{} {}", pulses.platform_name(i), quantity)));
    };
    put({"x_m", "y_m", "z_m"});
    if (world.earth) put({"latitude_deg", "longitude_deg", "height_m"});
    put({"vx_mps", "vy_mps", "vz_mps", "rx_deg", "ry_deg", "rz_deg"});
  }
  std::vector<const char*> of_target{"distance_m", "delay_s", "radial_speed_mps", "amplitude_v"};
  if (pulses.geometry().advances()) of_target.insert(of_target.begin() + 2, "phase_delay_s");
  pulses.each_target([&](std::size_t i) {
    for (const char* quantity : of_target) out.put(",target {} {}", i + 1, quantity);
  });
  out.put("\n");
}

void put_exact(PieceWriter& out, double value) {
  if (std::isfinite(value))
    out.put(",{}", core::format_number(value));
  else
    out.put(",{}", value);
}

void put_exact(PieceWriter& out, const core::Vec3& v) {
  for (const double value : {v.x, v.y, v.z}) put_exact(out, value);
}

void put_place(PieceWriter& out, const radar::Geodetic& place) {
  put_exact(out, core::deg_per_rad * place.latitude_rad);
  put_exact(out, core::deg_per_rad * place.longitude_rad);
  put_exact(out, place.height_m);
}

void put_csv_line(PieceWriter& out, const TablePulses& pulses, const WorldColumns& world) {
  const PulseGeometry& geometry = pulses.geometry();
  out.put("{}", geometry.pulse());
  put_exact(out, geometry.send_time_s());
  if (world.epoch)
    out.put(",{}", radar::format_instant(radar::later(*world.epoch, geometry.send_time_s()), radar::TimeScale::utc));
  put_exact(out, geometry.carrier_hz());
  for (std::size_t i = 0; i < pulses.platforms(); ++i) {
    const radar::Pose pose = pulses.pose(i);
    put_exact(out, pose.position_world_m);
    if (world.earth) put_place(out, world.earth->geodetic_of(pose.position_world_m));
    put_exact(out, pose.velocity_world_mps);
    put_exact(out, rotation_deg(pose));
  }
  pulses.each_target([&](std::size_t i) {
    const ScattererView view = geometry.view(i);
    put_exact(out, view.distance_m);
    put_exact(out, view.delay_s);
    if (geometry.advances()) put_exact(out, view.phase_delay_s(geometry.carrier_hz()));
    put_exact(out, view.speed_mps);
    put_exact(out, std::abs(view.amplitude_sqrt_w));
  });
  out.put("\n");
}

}  // namespace

void write_geometry_text(const scene::Scene& scene, const scene::GeometryTable& table, const Write& write,
                         const core::StopFlag* stop) {
  CORE_EXPECT(write);
  TablePulses pulses(scene, table, stop);
  if (pulses.range().count() == 0) return;  // As the originals: not even headings.
  PieceWriter out(write);
  const char separator = table.separator == scene::GeometryTable::Separator::comma ? ',' : ' ';
  for (int line = 0; line < header_lines; ++line) put_header_line(out, line, pulses, table.columns);
  pulses.each([&] {
    out.put("{:>9}{}", pulses.geometry().pulse(), separator);
    if ((table.columns & geometry_time) != 0) put_number(out, pulses.geometry().send_time_s(), 12, 8, separator);
    if ((table.columns & geometry_frequency) != 0)
      put_number(out, pulses.geometry().carrier_hz() / 1e9, 12, 8, separator);
    put_platforms(out, pulses, table.columns, separator);
    put_targets(out, pulses, table, separator);
    out.put("\n");
  });
  out.flush();
}

void write_geometry_csv(const scene::Scene& scene, const scene::GeometryTable& table, const Write& write,
                        const core::StopFlag* stop) {
  CORE_EXPECT(write);
  TablePulses pulses(scene, table, stop);
  PieceWriter out(write);
  const WorldColumns world(scene.world);
  put_csv_header(out, pulses, world);
  pulses.each([&] { put_csv_line(out, pulses, world); });
  out.flush();
}

}  // namespace sarsim::simulate
