#include "cli/command/info_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "scene/model/read_path.hpp"
#include "scene/model/world_frame.hpp"
#include "simulate/survey/places.hpp"

namespace sarsim::cli {

namespace {

constexpr std::size_t max_listed = 20;

// Moments of a scene as dates.
std::optional<std::string> utc_text(const scene::World& world, double time_s) {
  const auto epoch = scene::epoch_of(world).instant;
  if (!epoch) return std::nullopt;
  constexpr int digits = 6;
  return radar::format_instant(radar::later(*epoch, time_s), radar::TimeScale::utc, digits);
}

// So that nothing reads -0.000: adding 0 turns -0 into 0.
double whole(double value, double units) { return std::round(value * units) / units + 0.0; }

// Centimetres on the ground and millimetres of height.
std::string place_text(const radar::Geodetic& place) {
  return fmt::format("{:.7f} deg, {:.7f} deg, {:.3f} m", whole(core::deg_per_rad * place.latitude_rad, 1e7),
                     whole(core::deg_per_rad * place.longitude_rad, 1e7), whole(place.height_m, 1e3));
}

void write_place(core::JsonWriter& json, const radar::Geodetic& place) {
  json.member("latitude_deg", core::deg_per_rad * place.latitude_rad)
      .member("longitude_deg", core::deg_per_rad * place.longitude_rad)
      .member("height_m", place.height_m);
}

// Gathers the same facts as text and as JSON.
class WorldInfo {
 public:
  WorldInfo(const scene::Scene& scene, const simulate::ResolvedScene& resolved, bool all, core::JsonWriter& json)
      : scene_(scene),
        resolved_(resolved),
        max_(all ? std::numeric_limits<std::size_t>::max() : max_listed),
        earth_(scene::earth_of(scene.world)),
        time_s_(scene::needed_times(scene).first_s),
        json_(json) {}

  std::string add() {
    json_.key("world");
    if (!earth_ && !scene::epoch_of(scene_.world).instant) {
      json_.null();
      add_files();
      return std::move(text_);
    }
    json_.begin_object();
    text_ += "\nworld\n";
    add_anchor();
    add_epoch();
    add_files();
    if (earth_) add_places();
    json_.end_object();
    return std::move(text_);
  }

 private:
  void add_line(std::string_view label, std::string_view value) { text_ += fmt::format("  {:<24} {}\n", label, value); }

  void add_anchor() {
    json_.member("frame", earth_ ? "earth" : "flat");
    if (!earth_) return;
    const radar::Anchor& anchor = earth_->anchor();
    add_line("anchor", fmt::format("{}, heading {} deg", place_text(anchor.origin),
                                   core::format_number(scene_.world.heading.deg())));
    json_.key("anchor").begin_object();
    write_place(json_, anchor.origin);
    json_.member("heading_deg", core::deg_per_rad * anchor.heading_rad).end_object();
  }

  void add_epoch() {
    const auto epoch = utc_text(scene_.world, 0.0);
    json_.key("epoch");
    epoch ? json_.value(*epoch) : json_.null();
    if (epoch) add_line("epoch", *epoch);
  }

  void add_files() {
    for (const scene::Platform& platform : scene_.platforms)
      if (platform.read_path && !platform.read_path->description.empty())
        add_line(fmt::format("path of {}", platform.name),
                 platform.path != scene::Platform::Path::ephemeris
                     ? platform.read_path->description
                     : fmt::format("{}: {}", platform.ephemeris_file, platform.read_path->description));
  }

  void add_places() {
    add_line("places at", time_text(scene_.world, time_s_));
    json_.member("time_s", time_s_);
    const std::size_t platforms = scene_.platforms.size();
    const auto platforms_m = simulate::platform_places_m(resolved_, time_s_, std::min(max_, platforms));
    json_.key("platforms").begin_array();
    for (std::size_t i = 0; i < platforms_m.size(); ++i)
      add_place(fmt::format("  platform {}", resolved_.platforms[i].name), resolved_.platforms[i].name, platforms_m[i]);
    json_.end_array();
    add_rest(platforms, platforms_m.size());
    const auto targets_m = simulate::target_places_m(resolved_, time_s_, max_);
    json_.key("targets").begin_array();
    for (std::size_t i = 0; i < targets_m.size(); ++i)
      add_place(fmt::format("  target {}", i + 1), std::to_string(i + 1), targets_m[i]);
    json_.end_array();
    add_rest(resolved_.scatterers.targets(), targets_m.size());
  }

  void add_place(const std::string& label, const std::string& name, const core::Vec3& world_m) {
    const radar::Geodetic place = earth_->geodetic_of(world_m);
    add_line(label, place_text(place));
    json_.begin_object().member("name", name);
    write_place(json_, place);
    json_.end_object();
  }

  void add_rest(std::size_t count, std::size_t listed) {
    if (listed < count) text_ += fmt::format("    ... and {} more; list them with --all\n", count - listed);
  }

  const scene::Scene& scene_;
  const simulate::ResolvedScene& resolved_;
  std::size_t max_;
  std::optional<radar::EarthFrame> earth_;
  double time_s_;
  core::JsonWriter& json_;
  std::string text_;
};

}  // namespace

std::string world_text(const scene::Scene& scene, const simulate::ResolvedScene& resolved, bool all,
                       core::JsonWriter& json) {
  return WorldInfo(scene, resolved, all, json).add();
}

std::string time_text(const scene::World& world, double time_s) {
  const std::string text = core::format_number(time_s) + " s";
  const auto utc = utc_text(world, time_s);
  return utc ? fmt::format("{} ({})", text, *utc) : text;
}

void write_utc(core::JsonWriter& json, const scene::World& world, double first_s, double last_s) {
  const auto first = utc_text(world, first_s);
  const auto last = utc_text(world, last_s);
  if (!first || !last) return;
  json.member("first_utc", *first).member("last_utc", *last);
}

}  // namespace sarsim::cli
