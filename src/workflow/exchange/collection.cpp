#include "workflow/exchange/collection.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/task/worker_pool.hpp"
#include "core/text/separated.hpp"
#include "simulate/run/computed_rows.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/input/earth_place.hpp"

namespace sarsim::workflow {

namespace {

std::vector<double> numbers_of(const std::string& text, std::size_t count, const char* option, const char* expected) {
  const auto numbers = core::numbers_between_commas(text);
  if (!numbers || numbers->size() != count)
    throw core::InvalidRequest({core::error(fmt::format("{} is malformed", option)).found(text).expected(expected)});
  return *numbers;
}

void expect_exchangeable(const simulate::Acquisition& acquisition, core::Problems& problems) {
  if (acquisition.scene->options.profile != scene::Profile::physical)
    problems.push_back(core::error("the classic profile has another speed of light and other delays than the standard")
                           .found("classic")
                           .expected("the physical profile")
                           .hint("add --profile physical"));
  if (!acquisition.reception.is_raw())
    problems.push_back(
        core::error("CPHD and CRSD are made of raw pulses, but the recording is compressed")
            .expected("raw processing")
            .hint("name the scene, from which raw pulses are computed, or record with processing = \"raw\""));
  if (acquisition.link.stc != scene::Radar::Stc::none)
    problems.push_back(core::error("STC changes the amplitudes along a row, which the standard cannot describe")
                           .found("STC")
                           .expected("no STC")
                           .hint("leave out the STC of the radar"));
  if (acquisition.scene->options.eclipsing == scene::Eclipsing::blanked)
    problems.push_back(core::error("blanked samples have no place in a phase history")
                           .found("eclipsing = \"blanked\"")
                           .expected("none"));
}

// A recording with its rows and what the scene says of its world.
struct Opened {
  std::shared_ptr<const simulate::Acquisition> acquisition;
  core::SampleRows<double> rows;
  scene::World world;
  std::size_t simulation = 0;
  std::vector<std::filesystem::path> sources;
};

Opened opened_scene(RecordingArguments arguments, const core::WorkControl& control, core::Problems& remarks) {
  if (!arguments.overrides.pulse) arguments.overrides.pulse = scene::PulseDefinition::band_limited;
  auto [input, simulation] = open_script(arguments, records_pulses, control);
  core::append(remarks, std::move(input.problems));
  const simulate::Acquisition window = simulate::acquisition_of(input.scene, simulation, input.resolved);
  scene::Simulation& recorded = input.scene.simulations[simulation];
  recorded = recorded_for_sar(recorded, window);
  auto acquisition =
      std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(input.scene, simulation, input.resolved));
  return {acquisition, simulate::computed_rows(acquisition), input.scene.world, simulation, std::move(input.sources)};
}

Opened opened_file(const RecordingArguments& arguments, const core::WorkControl& control, core::Problems& remarks) {
  const auto problems_of = [](const simulate::Acquisition& acquisition) {
    core::Problems problems;
    expect_exchangeable(acquisition, problems);
    return problems;
  };
  StoredRecording stored = open_recording(arguments, records_pulses, problems_of, control);
  core::append(remarks, std::move(stored.problems));
  return {stored.acquisition, std::move(stored.rows), stored.scene.world, stored.simulation, std::move(stored.sources)};
}

// Time 0 of the file: the last whole second of slow time before the first pulse.
void set_start(const radar::Instant& epoch, Collection& collection) {
  const double first_s =
      collection.acquisition->link.repetition.send_time_s(collection.acquisition->timing.pulses.first);
  collection.start_s = std::floor(first_s);
  collection.start = radar::later(epoch, collection.start_s);
}

}  // namespace

ReferencePoint reference_point_from(const std::string& text) {
  if (text == "fixed") return {};
  if (text == "moving") return {ReferencePoint::Kind::moving, {}};
  const std::vector<double> xyz = numbers_of(text, 3, "--reference-point", "fixed, moving or X,Y,Z in m");
  return {ReferencePoint::Kind::given, {xyz[0], xyz[1], xyz[2]}};
}

std::string Collection::start_text() const { return radar::format_instant(start, radar::TimeScale::utc); }

Collection open_collection(const CollectionArguments& arguments, const core::WorkControl& control,
                           core::Problems& remarks) {
  Opened opened = names_script(arguments.input) ? opened_scene(arguments.input, control, remarks)
                                                : opened_file(arguments.input, control, remarks);
  core::Problems problems = problems_of_sar(*opened.acquisition, true);
  expect_exchangeable(*opened.acquisition, problems);
  if (core::has_errors(problems)) throw core::InvalidRequest(core::ranked(std::move(problems)));
  EarthPlace place = earth_place(opened.world, arguments.anchor, arguments.format);
  core::append(remarks, std::move(place.remarks));
  Collection collection{.acquisition = opened.acquisition,
                        .rows = std::move(opened.rows),
                        .computed = names_script(arguments.input),
                        .earth = place.earth,
                        .flat = opened.world.frame == scene::World::Frame::flat,
                        .start = {},
                        .reference = arguments.reference,
                        .name = {},
                        .simulation = opened.simulation,
                        .sources = std::move(opened.sources)};
  set_start(place.epoch, collection);
  return collection;
}

struct CollectionGeometry::Reference {
  simulate::ResolvedScene scene;
  simulate::Link radar;
  std::optional<simulate::PulseGeometry> geometry;
};

CollectionGeometry::CollectionGeometry(const Collection& collection)
    : collection_(&collection), reference_(std::make_unique<Reference>()) {
  const simulate::Acquisition& acquisition = *collection.acquisition;
  simulate::ResolvedScene& scene = reference_->scene;
  scene.conventions = acquisition.scene->conventions;
  scene.options = acquisition.scene->options;
  scene.turning = acquisition.scene->turning;
  scene.platforms = acquisition.scene->platforms;
  reference_->radar = acquisition.link;
  reference_->radar.air = nullptr;
  const std::int64_t middle = acquisition.timing.pulses.first + acquisition.timing.pulses.count() / 2;
  const radar::Track& track = scene.platforms[acquisition.link.platform].track;
  const radar::Pose pose = track.at(acquisition.link.repetition.send_time_s(middle), middle);
  middle_m_ = collection.reference.kind == ReferencePoint::Kind::given ? collection.reference.given_world_m
                                                                       : scene_middle_m(acquisition);
  expect_possible_place(collection.earth.ecef_from_world(middle_m_), "the reference point");
  expect_possible_place(collection.earth.ecef_from_world(pose.position_world_m), "the radar");
  antenna_m_ = pose.position_world_m;
  core::Vec3 along = pose.velocity_world_mps;
  if (collection.flat) along.z = 0.0;
  along_ = (1.0 / core::norm(along)) * along;
  height_m_ = collection.earth.geodetic_of(middle_m_).height_m;
  simulate::Scatterer point;
  point.platform = static_cast<std::uint32_t>(scene.platforms.size() - 1);  // The world itself.
  point.position_m = middle_m_;
  scene.scatterers.push_back(point);
  scene.platforms.back().middle_m = middle_m_;
  scene.platforms.back().radius_m = 0.0;
  reference_->geometry.emplace(scene, reference_->radar);
}

CollectionGeometry::~CollectionGeometry() = default;

core::Vec3 CollectionGeometry::reference_m(std::size_t row) {
  if (collection_->reference.kind != ReferencePoint::Kind::moving) return middle_m_;
  const simulate::Acquisition& acquisition = *collection_->acquisition;
  const std::int64_t pulse = acquisition.timing.first_pulse_of_row(row);
  const radar::Pose pose = acquisition.scene->platforms[acquisition.link.platform].track.at(
      acquisition.link.repetition.send_time_s(pulse), pulse);
  core::Vec3 point_m = middle_m_ + core::dot(pose.position_world_m - antenna_m_, along_) * along_;
  if (collection_->flat) return point_m;
  radar::Geodetic place = collection_->earth.geodetic_of(point_m);
  place.height_m = height_m_;
  return collection_->earth.world_of(place);
}

CollectedPulse CollectionGeometry::pulse_of(std::size_t row) {
  const simulate::Acquisition& acquisition = *collection_->acquisition;
  simulate::ResolvedScene& scene = reference_->scene;
  if (collection_->reference.kind == ReferencePoint::Kind::moving) {
    simulate::Scatterer point = scene.scatterers.front();
    point.position_m = reference_m(row);
    scene.scatterers = {};
    scene.scatterers.push_back(point);
    scene.platforms.back().middle_m = point.position_m;
  }
  simulate::PulseGeometry& geometry = *reference_->geometry;
  geometry.set_pulse(acquisition.timing.first_pulse_of_row(row));
  const simulate::ScattererView view = geometry.view(0);
  const radar::Pose& sent = geometry.radar_pose();
  const double time_s = geometry.send_time_s();
  const radar::Pose received =
      scene.platforms[acquisition.link.platform].track.at(time_s + view.delay_s, geometry.pulse());
  const radar::EarthFrame& earth = collection_->earth;
  CollectedPulse pulse{{}, view.delay_s, view.clock, geometry.carrier_hz()};
  raster::PhaseVector& v = pulse.vector;
  v.tx_time_s = time_s - collection_->start_s;
  v.tx_m = earth.ecef_from_world(sent.position_world_m);
  v.tx_mps = earth.ecef_axes_from_world(sent.velocity_world_mps);
  v.rcv_time_s = v.tx_time_s + view.delay_s;
  v.rcv_m = earth.ecef_from_world(received.position_world_m);
  v.rcv_mps = earth.ecef_axes_from_world(received.velocity_world_mps);
  v.srp_m = earth.ecef_from_world(scene.scatterers.front().position_m);
  const auto rate = [&](const core::Vec3& from_m, const core::Vec3& velocity_mps) {
    const core::Vec3 way = from_m - v.srp_m;
    return core::dot(way, velocity_mps) / core::norm(way);
  };
  const double c = scene.conventions.light_speed_mps;
  v.doppler = -(rate(v.tx_m, v.tx_mps) + rate(v.rcv_m, v.rcv_mps)) / c;
  const radar::Pulse& sent_pulse = acquisition.link.pulse;
  if (sent_pulse.kind == radar::Pulse::Kind::chirp && sent_pulse.sweep_hz != 0.0) {
    v.rate2 = 2.0 / c * sent_pulse.width_s / sent_pulse.sweep_hz;
    v.rate1 = v.rate2 * pulse.carrier_hz;
  }
  return pulse;
}

}  // namespace sarsim::workflow
