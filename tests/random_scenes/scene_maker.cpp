#include "random_scenes/scene_maker.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include "core/maths/constants.hpp"
#include "random_scenes/field_maker.hpp"
#include "random_scenes/radar_maker.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::test {

namespace {

constexpr std::array<const char*, 6> platform_words{"Ship",   "Vehicle 7",   "Ballon-\xC3\xB6",
                                                    "Kite!x", "\"Q\" tower", "drone_3"};

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

class SceneMaker {
 public:
  explicit SceneMaker(std::uint64_t seed) : chance_(seed), functions_(chance_) {}

  scene::Scene make() {
    set_layout();
    set_options();
    add_platforms();
    for (int i = chance_.integer(1, chance_.one_in(40) ? 300 : chance_.one_in(4) ? 25 : 8); i > 0; --i)
      scene_.targets.push_back(target());
    if (chance_.one_in(3))
      for (int i = chance_.integer(1, 2); i > 0; --i) scene_.surfaces.push_back(surface());
    for (int i = chance_.one_in(4) ? 2 : 1; i > 0; --i) add_radar(i);
    for (int i = chance_.one_in(4) ? 2 : 1; i > 0; --i) scene_.simulations.push_back(simulation(i));
    if (chance_.one_in(3)) scene_.geometries.push_back(geometry());
    return scene_;
  }

 private:
  [[nodiscard]] double sample_m() const { return 0.5 * core::exact_light_speed_mps / layout_.sample_rate_hz; }

  void set_layout() {
    layout_.sample_rate_hz = chance_.size(1e6, 1e9);
    layout_.window_m = sample_m() * chance_.size(1.0, 400.0);
    layout_.spread_m = std::min(5e3, std::max(1.0, layout_.window_m * chance_.between(0.1, 0.8)));
    layout_.range_m = 2.0 * layout_.spread_m + chance_.size(30.0, 5e4);
    layout_.stepped = chance_.one_in(4);
    layout_.interval_s = chance_.size(2e-5, 0.2);
    layout_.start_s = layout_.interval_s * chance_.integer(-20, 200);
    layout_.duration_s = layout_.interval_s * chance_.integer(1, 10);
    radar_position_m_ = layout_.range_m * chance_.direction();
    largest_speed_mps_ = chance_.size(0.1, chance_.one_in(25) ? 3e5 : 2000.0);
  }

  void set_options() {
    using Options = scene::RunOptions;
    scene_.options = drawn<Options>(
        chance_, {},
        {{field<&Options::seed>(), [this](Options& o) { o.seed = chance_.coin() ? chance_.bits() : o.seed; }},
         {field<&Options::tolerance>(), [this](Options& o) {
            if (chance_.one_in(3)) o.tolerance = chance_.size(1e-9, 0.1);
          }}});
    layout_.profile = scene_.options.profile;
  }

  // The world where it is not defined, or a platform of that name; one for radars, and some for targets.
  void add_platforms() {
    radars_on_earth_ = chance_.one_in(6);
    if (radars_on_earth_ || chance_.coin()) {
      scene_.platforms.push_back(platform("Earth", radars_on_earth_ ? radar_position_m_ : core::Vec3{}));
      if (!radars_on_earth_) target_platforms_.emplace_back("Earth");
    } else {
      target_platforms_.emplace_back("Earth");
    }
    if (!radars_on_earth_) scene_.platforms.push_back(platform("Carrier of radars", radar_position_m_));
    const int most = radars_on_earth_ ? 1 : 0;
    for (int i = chance_.integer(most, 2); i > 0; --i) {
      const std::string name = platform_words[chance_.below(3) + 3 * static_cast<std::size_t>(i - 1)];
      scene_.platforms.push_back(platform(name, chance_.vector(0.3 * layout_.spread_m)));
      target_platforms_.push_back(name);
    }
    std::ranges::rotate(scene_.platforms,
                        scene_.platforms.begin() + static_cast<std::ptrdiff_t>(chance_.below(scene_.platforms.size())));
  }

  scene::UserFunction<3> path(const core::Vec3& about_m) {
    scene::UserFunction<3> path;
    const double around_s = chance_.one_in(3) ? 0.0 : chance_.size(0.01, 10.0);
    const double low = layout_.start_s - around_s;
    const double high = layout_.start_s + layout_.duration_s + around_s;
    const double middle = 0.5 * (low + high);
    const std::array<double, 3> start{about_m.x, about_m.y, about_m.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double speed = chance_.between(-largest_speed_mps_, largest_speed_mps_);
      const double bend = chance_.coin() ? 0.0 : 0.1 * speed * (high - low);
      path.part[axis] = functions_.points(chance_.integer(1, 5), low, high, [&](double t) {
        return start[axis] + speed * (t - middle) + bend * chance_.between(-1.0, 1.0);
      });
      if (start[axis] == 0.0 && chance_.one_in(8)) path.part[axis].knots.clear();
    }
    functions_.name_file(path);
    return path;
  }

  scene::UserFunction<3> turning() {
    scene::UserFunction<3> function;
    for (core::SampledFunction& axis : function.part)
      axis = functions_.curve(4, layout_.start_s, layout_.start_s + layout_.duration_s, -180.0, 180.0);
    if (chance_.one_in(6)) function.part[chance_.below(3)].knots.clear();
    functions_.name_file(function);
    return function;
  }

  // Responses to white noise: none, or at least two points.
  scene::UserFunction<3> envelope(double largest) {
    scene::UserFunction<3> function;
    for (core::SampledFunction& axis : function.part)
      if (!chance_.one_in(4))
        axis = functions_.points(chance_.integer(2, 5), chance_.coin() ? 0.0 : chance_.between(-0.1, 0.1),
                                 chance_.size(0.2, 5.0), [&](double) { return chance_.between(-largest, largest); });
    functions_.name_file(function);
    return function;
  }

  std::array<core::Angle, 3> angles(double largest_deg) {
    return {chance_.angle(largest_deg), chance_.angle(largest_deg), chance_.angle(largest_deg)};
  }

  scene::Platform platform(const std::string& name, const core::Vec3& about_m) {
    using P = scene::Platform;
    P platform;
    platform.name = name;
    FieldDraws<P> draws{{field<&P::name>(), {}},
                        {field<&P::position_m>(), [&](P& p) { p.position_m = about_m; }},
                        {field<&P::trajectory_m>(), [&](P& p) { p.trajectory_m = path(about_m); }},
                        {field<&P::rotation>(), [&](P& p) { p.rotation = angles(chance_.coin() ? 180.0 : 0.0); }},
                        {field<&P::rotation_deg>(), [&](P& p) { p.rotation_deg = turning(); }},
                        {field<&P::rotation_rate>(), [&](P& p) {
                           if (chance_.one_in(3)) p.rotation_rate = angles(chance_.size(0.01, 300.0));
                         }}};
    add_errors(draws);
    return drawn(chance_, platform, draws);
  }

  void add_errors(FieldDraws<scene::Platform>& draws) {
    using P = scene::Platform;
    draws[field<&P::position_stddev_m>()] = [this](P& p) { p.position_stddev_m = chance_.magnitudes(1e-4, 1.0); };
    draws[field<&P::position_envelope>()] = [this](P& p) { p.position_envelope = envelope(chance_.size(1e-4, 1.0)); };
    draws[field<&P::rotation_stddev>()] = [this](P& p) {
      const core::Vec3 deg = chance_.magnitudes(1e-4, 1.0);
      p.rotation_stddev = {core::Angle::from_deg(deg.x), core::Angle::from_deg(deg.y), core::Angle::from_deg(deg.z)};
    };
    draws[field<&P::rotation_envelope>()] = [this](P& p) { p.rotation_envelope = envelope(chance_.size(1e-4, 1.0)); };
  }

  // As the platform is called, in other case, or by its beginning.
  std::string reference_to(const std::string& name) {
    std::string other = name;
    if (chance_.one_in(4))
      std::ranges::transform(other, other.begin(),
                             [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    if (chance_.one_in(4)) other.resize(std::max<std::size_t>(3, name.size() - 2));
    const std::size_t meant = scene::find_platform(scene_, name);
    return meant != scene::not_found && scene::find_platform(scene_, other) == meant ? other : name;
  }

  std::string target_platform() { return reference_to(target_platforms_[chance_.below(target_platforms_.size())]); }

  core::Angle jitter() { return core::Angle::from_deg(chance_.one_in(3) ? chance_.size(1e-2, 20.0) : 0.0); }

  scene::Target target() {
    using T = scene::Target;
    using Traits = scene::TargetTraits;
    return drawn<T>(
        chance_, {},
        {{field<&T::platform>(), [this](T& t) { t.platform = target_platform(); }},
         {field<&T::position_m>(),
          [this](T& t) { t.position_m = chance_.vector(chance_.one_in(8) ? 0.0 : layout_.spread_m); }},
         {field<&T::traits, &Traits::position_stddev_m>(),
          [this](T& t) {
            t.traits.edit().position_stddev_m = chance_.one_in(4) ? chance_.magnitudes(1e-4, 1.0) : core::Vec3{};
          }},
         {field<&T::rcs_m2>(),
          [this](T& t) { t.rcs_m2 = chance_.one_in(20) ? chance_.between(-1.0, 0.0) : chance_.size(1e-3, 1e4); }},
         {field<&T::traits, &Traits::rcs_stddev_m2>(),
          [this](T& t) { t.traits.edit().rcs_stddev_m2 = chance_.one_in(3) ? chance_.size(1e-3, 1e2) : 0.0; }},
         {field<&T::traits, &Traits::azimuth>(), [this](T& t) { t.traits.edit().azimuth = chance_.angle(360.0); }},
         {field<&T::traits, &Traits::elevation>(), [this](T& t) { t.traits.edit().elevation = chance_.angle(180.0); }},
         {field<&T::traits, &Traits::azimuth_stddev>(), [this](T& t) { t.traits.edit().azimuth_stddev = jitter(); }},
         {field<&T::traits, &Traits::elevation_stddev>(),
          [this](T& t) { t.traits.edit().elevation_stddev = jitter(); }},
         {field<&T::traits, &Traits::gain_db>(), [this](T& t) {
            t.traits.edit().gain_db.part[0] =
                functions_.curve(6, chance_.between(0.0, 30.0), chance_.between(40.0, 180.0), -60.0, 10.0);
            functions_.name_file(t.traits.edit().gain_db);
          }}});
  }

  scene::Surface surface() {
    scene::Surface surface;
    surface.platform = target_platform();
    const core::Vec3 at = chance_.vector(0.5 * layout_.spread_m);
    for (core::Vec3& corner : surface.corner_m) corner = at + chance_.vector(8.0);
    return surface;
  }

  void add_radar(int number) {
    scene::Radar radar = random_radar(chance_, functions_, layout_, radar_position_m_);
    radar.name = number == 2 ? "Second radar" : "R1";
    radar.platform = reference_to(radars_on_earth_ ? "Earth" : "Carrier of radars");
    scene_.radars.push_back(std::move(radar));
  }

  // Between whole pulses, so that rounding decides nothing.
  template <class Product>
  const scene::Radar& set_window(Product& product) {
    const scene::Radar& radar = scene_.radars[chance_.below(scene_.radars.size())];
    product.radar = radar.name;
    const int burst = layout_.stepped ? radar.carrier_steps * radar.pulses_per_step : 1;
    const int pulses = layout_.stepped ? burst * chance_.integer(1, 2) : chance_.integer(1, 10);
    const bool extra = !layout_.stepped || chance_.coin();
    const int first = extra ? chance_.integer(-20, 200) : burst * chance_.integer(-3, 30);
    product.time_start_s = layout_.interval_s * (first - 0.25);
    product.time_end_s = layout_.interval_s * (first + pulses - 0.75 + (extra ? burst : 0));
    product.range_start_m = layout_.range_m - layout_.window_m * chance_.between(0.1, 0.9);
    // A target at rest in the middle then has an edge of its pulse on a sample.
    if (chance_.one_in(4)) product.range_start_m = layout_.range_m - sample_m() * chance_.integer(0, 20);
    product.range_end_m = product.range_start_m + layout_.window_m;
    return radar;
  }

  // What `set_window` has set.
  template <class Product>
  FieldDraws<Product> windowed() {
    return {{field<&Product::radar>(), {}},
            {field<&Product::range_start_m>(), {}},
            {field<&Product::range_end_m>(), {}},
            {field<&Product::time_start_s>(), {}},
            {field<&Product::time_end_s>(), {}}};
  }

  scene::Simulation simulation(int number) {
    using S = scene::Simulation;
    S begun;
    const scene::Radar& radar = set_window(begun);
    begun.file = number == 2 ? "the other.dat" : "out/sim.bin";
    begun.sample_rate_hz = layout_.sample_rate_hz;
    const bool profiles = radar.carrier == scene::Radar::Carrier::stepped && radar.carrier_steps > 1 && layout_.stepped;
    FieldDraws<S> draws = windowed<S>();
    draws[field<&S::sample_rate_hz>()] = draws[field<&S::file>()] = {};
    draws[field<&S::lsb_v>()] = [this](S& s) { s.lsb_v = chance_.coin() ? chance_.size(1e-14, 1e-3) : 0.0; };
    draws[field<&S::processing>()] = [this, profiles](S& s) {
      s.processing = profiles && chance_.coin() ? scene::Processing::srp : chance_.one_of<scene::Processing>(2);
    };
    draws[field<&S::oversampling>()] = [this](S& s) {
      s.oversampling = chance_.coin() ? chance_.between(1.0, 4.0) : 1.0;
    };
    draws[field<&S::width_factor>()] = [this](S& s) {
      s.width_factor = chance_.coin() ? chance_.between(1.0, 3.0) : 0.0;
    };
    return drawn(chance_, begun, draws);
  }

  scene::GeometryTable geometry() {
    using G = scene::GeometryTable;
    G begun;
    set_window(begun);
    FieldDraws<G> draws = windowed<G>();
    draws[field<&G::file>()] = [this](G& g) { g.file = chance_.coin() ? "geometry.txt" : "g.csv"; };
    return drawn(chance_, begun, draws);
  }

  Chance chance_;
  FunctionMaker functions_;
  scene::Scene scene_;
  Layout layout_;
  core::Vec3 radar_position_m_;
  double largest_speed_mps_ = 0.0;
  bool radars_on_earth_ = false;
  std::vector<std::string> target_platforms_;
};

}  // namespace

scene::Scene random_scene(std::uint64_t seed) { return SceneMaker(seed).make(); }

namespace {

// Calls look(block, field, object) for every user-defined function of a scene, which may be const.
template <class AnyScene, class Look>
void each_function(AnyScene& scene, const Look& look) {
  scene::for_each_kind([&](const auto& kind) {
    for (auto& object : scene.*kind.list)
      for (const auto& field : scene::table_of(kind).fields())
        if (field.function != nullptr) look(*field.spec.block, field, object);
  });
}

}  // namespace

void visit_functions(const scene::Scene& scene, const FunctionVisitor& visit) {
  each_function(scene, [&](const scene::FunctionBlock& block, const auto& field, const auto& object) {
    const auto function = std::get<scene::ConstFunctionRef>(field.get(object));
    visit(block, function.parts, *function.file);
  });
}

void keep_inline(scene::Scene& scene) {
  each_function(scene, [](const scene::FunctionBlock&, const auto& field, auto& object) {
    field.function(object).file->clear();
  });
}

scene::DataFileLoader loader_of(const scene::Scene& scene) {
  std::map<std::string, std::string> texts;
  visit_functions(scene, [&](const scene::FunctionBlock& block, std::span<const core::SampledFunction> parts,
                             const std::string& file) {
    if (!file.empty()) texts[file] = scene::write_data_file(parts, block);
  });
  return [texts](const std::string& name) {
    const auto found = texts.find(name);
    if (found == texts.end()) return scene::DataFileText{"", "", "data file not found"};
    return scene::DataFileText{name, found->second, ""};
  };
}

std::string spelled_otherwise(const std::string& script) {
  std::string text = "$options Profile Physical pulse ideal cubic_ends Chords ambiguous_echoes Strong eclipsing None\n";
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("SINX ", 0) == 0) line.replace(0, 4, "SIMPLE");
    // A line of a keyword alone begins with capitals and says nothing else before its comment.
    const std::size_t length = line.find_first_of(" !");
    const bool name = line.find("! Name ") != std::string::npos || line.find("! Platform ") != std::string::npos;
    const bool keyword = !name && length != std::string::npos && length > 2 &&
                         line.find_first_not_of(' ', length) != std::string::npos &&
                         line[line.find_first_not_of(' ', length)] == '!';
    if (keyword && std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(length), is_capital))
      for (std::size_t i = 0; i < length; ++i) line[i] = static_cast<char>(line[i] - 'A' + 'a');
    text += line + '\n';
  }
  return text;
}

}  // namespace sarsim::test
