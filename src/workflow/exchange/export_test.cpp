#include "workflow/exchange/export.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <set>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/cphd/cphd_test_support.hpp"
#include "workflow/exchange/phase_history.hpp"

namespace sarsim::workflow::export_test {

using namespace raster::cphd_test;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr double light_mps = 299'792'458.0;

/// An aircraft 3 km from three targets; about 9 x 9 cells of 3 m.
const std::string scene_text = R"(format = "sarsim 2"
[[platform]]
name = "Plane"
path = { type = "line", start = [0, -2500, 1500], velocity = [100, 0, 0] }
[[target]]
positions = [[0, 0, 0], [12, 9, 0], [-9, -15, 2]]
[[radar]]
name = "X"
platform = "Plane"
pulse = { type = "chirp", bandwidth = "60 MHz", width = "0.5 us" }
repetition = "120 Hz"
carrier = "9.6 GHz"
power = "1 kW"
[[recording]]
radar = "X"
file = "small.h5"
format = "hdf5"
sample_rate = "75 MHz"
range = ["2850 m", "3000 m"]
time = ["-0.6 s", "0.6 s"]
)";

/// A folder with that scene, removed at the end.
struct SmallScene {
  SmallScene() : folder(fs::temp_directory_path() / ("sarsim_export_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
    write(scene_text);
  }
  ~SmallScene() { fs::remove_all(folder); }
  void write(const std::string& text) const { std::ofstream(folder / "small.toml") << text; }
  [[nodiscard]] ExportRequest request(const std::string& name) const {
    ExportRequest request;
    request.input.path = (folder / "small.toml").string();
    request.output = folder / name;
    request.force = true;
    request.threads = 1;
    request.anchor = radar::Anchor{};
    return request;
  }
  fs::path folder;
};

core::Observer hears(core::Problems& heard) {
  core::Observer observer;
  observer.remark = [&heard](const core::Problems& problems) {
    heard.insert(heard.end(), problems.begin(), problems.end());
  };
  return observer;
}

std::string words_of(const core::Problems& problems) {
  std::string words;
  for (const core::Problem& problem : problems) words += core::to_string(problem) + "\n";
  return words;
}

std::string refusal_of(const ExportRequest& request) {
  try {
    export_recording(request, {});
  } catch (const core::InvalidRequest& refused) {
    return words_of(refused.problems);
  }
  return "nothing was refused";
}

/// A whole file in memory.
struct WholeFile {
  raster::CphdDescription d;
  std::vector<raster::PhaseVector> vectors;
  std::vector<std::vector<std::complex<float>>> samples;
};

WholeFile whole_of(const fs::path& path) {
  const Opened opened = opened_of(path);
  EXPECT_TRUE(opened.file) << opened.text();
  WholeFile whole{opened.file->description(), {}, {}};
  const raster::PhaseChannel& channel = whole.d.channels.front();
  whole.vectors.resize(channel.vectors);
  opened.file->read_vectors(0, 0, whole.vectors);
  for (std::size_t i = 0; i < channel.vectors; ++i) {
    whole.samples.emplace_back(channel.samples);
    opened.file->read_samples(0, i, whole.vectors[i].amplitude, whole.samples.back());
  }
  return whole;
}

// The formula of the standard: sum of A exp(-2 pi j f dTOA) over the targets, by the places that the file itself says;
// amplitudes are the file's own, from the first frequency of each vector where targets would be alone.
TEST(ExportCphd, HasThePhasesOfTheStandard) {
  const SmallScene scene;
  std::string one_target = scene_text;
  one_target.replace(one_target.find("[[0, 0, 0], [12, 9, 0], [-9, -15, 2]]"), 37, "[[12, 9, 0]]");
  scene.write(one_target);
  ExportRequest request = scene.request("one.cphd");
  request.reference = ReferencePoint{ReferencePoint::Kind::given, {-9.0, -15.0, 2.0}};
  export_recording(request, {});
  const WholeFile file = whole_of(request.output);
  const radar::EarthFrame earth{radar::Anchor{}};
  const core::Vec3 target_m = earth.ecef_from_world({12.0, 9.0, 0.0});
  double worst_rad = 0.0, worst_level = 0.0;
  for (std::size_t i = 0; i < file.vectors.size(); ++i) {
    const raster::PhaseVector& v = file.vectors[i];
    const double toa_s =
        (core::norm(v.tx_m - target_m) + core::norm(v.rcv_m - target_m) - v.reference_way_m()) / light_mps;
    const double level = std::abs(std::complex<double>(file.samples[i][file.samples[i].size() / 2]));
    for (std::size_t k = 0; k < file.samples[i].size(); ++k) {
      const double turns = (v.first + static_cast<double>(k) * v.step) * toa_s;
      const std::complex<double> rest =
          std::complex<double>(file.samples[i][k]) * std::polar(1.0, 2.0 * core::pi * (turns - std::round(turns)));
      worst_rad = std::max(worst_rad, std::abs(std::arg(rest)));
      worst_level = std::max(worst_level, std::abs(std::abs(rest) / level - 1.0));
    }
  }
  // The Doppler frequencies of target and reference point differ by 46 Hz. By so much their spectra are shifted, whose
  // ripples are 1/(0.5 us) wide: 2 pi 46 Hz 0.5 us = 1.5e-4 rad, up to three times that at the edges of the band.
  EXPECT_LT(worst_rad, 5e-4);
  EXPECT_LT(worst_level, 5e-4);
}

TEST(ExportCphd, GivesTheSameBytesForAnyThreadsAndFromTheRecording) {
  const SmallScene scene;
  const ExportRequest one = scene.request("one.cphd");
  export_recording(one, {});
  ExportRequest many = scene.request("x/../many.cphd");
  many.output = scene.folder / "more" / "one.cphd";
  fs::create_directories(many.output.parent_path());
  many.threads = 7;
  export_recording(many, {});
  EXPECT_EQ(bytes_of(one.output), bytes_of(many.output));
}

// Each rule of the standard that a file could break, by its name in sarkit's checker.
struct Rule {
  const char* name;
  std::function<bool(const WholeFile&)> holds;
  std::function<void(WholeFile&)> breaks;
};

template <class Holds>
bool all_vectors(const WholeFile& file, const Holds& holds) {
  return std::ranges::all_of(file.vectors, holds);
}

bool increasing(const WholeFile& file) {
  for (std::size_t i = 1; i < file.vectors.size(); ++i)
    if (!(file.vectors[i - 1].tx_time_s < file.vectors[i].tx_time_s)) return false;
  return true;
}

double path_rate(const raster::PhaseVector& v) {
  const auto rate = [&](const core::Vec3& at_m, const core::Vec3& mps) {
    return core::dot(at_m - v.srp_m, mps) / core::norm(at_m - v.srp_m);
  };
  return rate(v.tx_m, v.tx_mps) + rate(v.rcv_m, v.rcv_mps);
}

using F = WholeFile;
using V = raster::PhaseVector;

V& first(F& file) { return file.vectors.front(); }

// Times of vectors.
std::vector<Rule> rules_of_times() {
  return {
      {"first_txtime", [](const F& f) { return f.vectors.front().tx_time_s >= 0.0; },
       [](F& f) { first(f).tx_time_s = -1e-3; }},
      {"time_increasing", increasing, [](F& f) { std::swap(f.vectors[1].tx_time_s, f.vectors[2].tx_time_s); }},
      {"rcv_after_tx", [](const F& f) { return all_vectors(f, [](const V& v) { return v.rcv_time_s > v.tx_time_s; }); },
       [](F& f) { first(f).rcv_time_s = first(f).tx_time_s; }},
      {"rcv_time_of_srp",
       [](const F& f) {
         return all_vectors(f, [](const V& v) {
           return std::abs((v.rcv_time_s - v.tx_time_s) * light_mps - v.reference_way_m()) < 1e-4;
         });
       },
       [](F& f) { first(f).rcv_time_s += 1e-11; }},
      {"channel_global_txtime",
       [](const F& f) {
         return all_vectors(f,
                            [&](const V& v) { return v.tx_time_s >= f.d.tx_time1_s && v.tx_time_s <= f.d.tx_time2_s; });
       },
       [](F& f) { f.d.tx_time2_s -= 1e-3; }},
  };
}

// What a channel says once of all its vectors.
std::vector<Rule> rules_of_channels() {
  return {
      {"channel_fxfixed",
       [](const F& f) {
         return !f.d.channels[0].fx_fixed || all_vectors(f, [&](const V& v) {
           return v.fx1_hz == f.vectors[0].fx1_hz && v.fx2_hz == f.vectors[0].fx2_hz;
         });
       },
       [](F& f) { f.vectors[3].fx2_hz += 1.0; }},
      {"channel_toafixed",
       [](const F& f) {
         return !f.d.channels[0].toa_fixed || all_vectors(f, [&](const V& v) {
           return v.toa1_s == f.vectors[0].toa1_s && v.toa2_s == f.vectors[0].toa2_s;
         });
       },
       [](F& f) { f.vectors[3].toa2_s *= 1.01; }},
      {"channel_srpfixed",
       [](const F& f) {
         return f.d.channels[0].srp_fixed == all_vectors(f, [&](const V& v) { return v.srp_m == f.vectors[0].srp_m; });
       },
       [](F& f) { f.d.channels[0].srp_fixed = !f.d.channels[0].srp_fixed; }},
      {"channel_fxc",
       [](const F& f) {
         return std::abs(f.d.channels[0].centre_hz - 0.5 * (f.vectors[0].fx1_hz + f.vectors[0].fx2_hz)) < 1.0;
       },
       [](F& f) { f.d.channels[0].centre_hz += 10.0; }},
      {"channel_fxbw",
       [](const F& f) { return std::abs(f.d.channels[0].band_hz - (f.vectors[0].fx2_hz - f.vectors[0].fx1_hz)) < 1.0; },
       [](F& f) { f.d.channels[0].band_hz += 10.0; }},
      {"channel_toasaved",
       [](const F& f) { return std::abs(f.d.channels[0].toa_s - (f.vectors[0].toa2_s - f.vectors[0].toa1_s)) < 1e-15; },
       [](F& f) { f.d.channels[0].toa_s *= 1.1; }},
      {"channel_positions_of_reference_vector", [](const F& f) { return f.d.channels[0].reference < f.vectors.size(); },
       [](F& f) { f.d.channels[0].reference = f.vectors.size(); }},
  };
}

// Bands and swaths.
std::vector<Rule> rules_of_bands() {
  return {
      {"channel_fx2_gt_fx1",
       [](const F& f) { return all_vectors(f, [](const V& v) { return v.fx2_hz > v.fx1_hz && v.fx1_hz > 0.0; }); },
       [](F& f) { std::swap(first(f).fx1_hz, first(f).fx2_hz); }},
      {"channel_global_toaswath",
       [](const F& f) {
         return all_vectors(f, [&](const V& v) { return v.toa1_s >= f.d.toa_min_s && v.toa2_s <= f.d.toa_max_s; });
       },
       [](F& f) { f.d.toa_max_s *= 0.5; }},
      {"channel_global_fxminmax",
       [](const F& f) {
         return all_vectors(f, [&](const V& v) { return v.fx1_hz >= f.d.fx_min_hz && v.fx2_hz <= f.d.fx_max_hz; });
       },
       [](F& f) { f.d.fx_min_hz += 1e6; }},
      {"channel_fx_osr",
       [](const F& f) {
         return all_vectors(f, [](const V& v) { return 1.0 / (v.step * (v.toa2_s - v.toa1_s)) >= 1.2; });
       },
       [](F& f) { first(f).step *= 4.0; }},
      {"samples_within_band",
       [](const F& f) {
         const double last = static_cast<double>(f.samples[0].size() - 1);
         return all_vectors(
             f, [&](const V& v) { return v.first == v.fx1_hz && std::abs(v.first + last * v.step - v.fx2_hz) < 1e-3; });
       },
       [](F& f) { first(f).first += 1e3; }},
  };
}

// Numbers that follow from others, and that are numbers.
std::vector<Rule> rules_of_numbers() {
  return {
      {"channel_afdop",
       [](const F& f) {
         return all_vectors(f, [](const V& v) { return std::abs(v.doppler + path_rate(v) / light_mps) < 1e-12; });
       },
       [](F& f) { first(f).doppler += 1e-9; }},
      {"channel_afrr1",
       [](const F& f) { return all_vectors(f, [](const V& v) { return std::abs(v.rate1 / v.rate2 - 9.6e9) < 1.0; }); },
       [](F& f) { first(f).rate1 *= 1.001; }},
      {"channel_afrr2",
       [](const F& f) {
         return all_vectors(f, [](const V& v) { return std::abs(v.rate2 * light_mps * 1.2e14 / 2.0 - 1.0) < 1e-12; });
       },
       [](F& f) { first(f).rate2 *= 1.001; }},
      {"channel_normal_signal_pvp", [](const F& f) { return all_vectors(f, [](const V& v) { return v.signal == 1; }); },
       [](F& f) { first(f).signal = 0; }},
      {"pvp_set_finiteness",
       [](const F& f) {
         return all_vectors(f, [](const V& v) {
           return std::ranges::all_of(raster::pvp_fields(), [&](const raster::PvpField& field) {
             return (field.number == nullptr || std::isfinite(v.*field.number)) &&
                    (field.place == nullptr || std::isfinite(core::norm(v.*field.place)));
           });
         });
       },
       [](F& f) { first(f).rcv_mps.y = NAN; }},
      {"channel_signal_data",
       [](const F& f) {
         double sum = 0.0;
         for (const auto& row : f.samples)
           for (const auto& sample : row) sum += static_cast<double>(std::norm(sample));
         return std::isfinite(sum) && sum > 0.0;
       },
       [](F& f) { f.samples[2][3] = NAN; }},
  };
}

// Places and axes.
std::vector<Rule> rules_of_places() {
  return {
      {"scene_plane_axis_vectors",
       [](const F& f) {
         return std::abs(core::dot(f.d.scene.x_axis, f.d.scene.y_axis)) < 1e-12 &&
                core::dot(core::cross(f.d.scene.x_axis, f.d.scene.y_axis), f.d.scene.origin_m) > 0.0;
       },
       [](F& f) { std::swap(f.d.scene.x_axis, f.d.scene.y_axis); }},
      {"imagearea_holds_the_targets",
       [](const F& f) {
         const raster::AreaRectangle& a = f.d.scene.area;
         const core::Vec3 target_m =
             radar::EarthFrame(radar::Anchor{}).ecef_from_world({12.0, 9.0, 0.0}) - f.d.scene.origin_m;
         const double x = core::dot(target_m, f.d.scene.x_axis), y = core::dot(target_m, f.d.scene.y_axis);
         return x > a.x1 && x < a.x2 && y > a.y1 && y < a.y2;
       },
       [](F& f) { f.d.scene.area.x2 = 5.0; }},
      {"txrcv_posvel_residuals",
       [](const F& f) {
         for (std::size_t i = 1; i < f.vectors.size(); ++i) {
           const V &a = f.vectors[i - 1], &b = f.vectors[i];
           const double dt = b.tx_time_s - a.tx_time_s;
           if (core::norm(b.tx_m - a.tx_m - 0.5 * dt * (a.tx_mps + b.tx_mps)) > 1e-6) return false;
           if (core::norm(b.rcv_m - b.tx_m - (b.rcv_time_s - b.tx_time_s) * b.rcv_mps) > 1e-6) return false;
         }
         return true;
       },
       [](F& f) { f.vectors[4].tx_mps = -f.vectors[4].tx_mps; }},
  };
}

std::vector<Rule> rules() {
  std::vector<Rule> all;
  for (const std::vector<Rule>& some :
       std::array{rules_of_times(), rules_of_channels(), rules_of_bands(), rules_of_numbers(), rules_of_places()})
    std::ranges::copy(some, std::back_inserter(all));
  return all;
}

TEST(ExportCphd, KeepsTheRulesOfTheStandard) {
  const SmallScene scene;
  for (const ReferencePoint::Kind kind : {ReferencePoint::Kind::fixed, ReferencePoint::Kind::moving})
    for (const raster::SignalEncodingName& entry : raster::signal_encodings) {
      ExportRequest request = scene.request("rules.cphd");
      request.encoding = entry.encoding;
      request.reference = ReferencePoint{kind, {}};
      export_recording(request, {});
      const WholeFile file = whole_of(request.output);
      for (const Rule& rule : rules()) {
        EXPECT_TRUE(rule.holds(file)) << rule.name << " " << entry.name;
        WholeFile broken = file;
        rule.breaks(broken);
        EXPECT_FALSE(rule.holds(broken)) << rule.name << " cannot fail";
      }
    }
}

TEST(ExportCphd, TheImageAreaIsThatOfTheTargetsWhateverTheReferencePointDoes) {
  const SmallScene scene;
  const auto area_of = [&](ReferencePoint::Kind kind) {
    ExportRequest request = scene.request("area.cphd");
    request.reference = ReferencePoint{kind, {}};
    export_recording(request, {});
    return whole_of(request.output).d.scene;
  };
  const raster::SceneCoordinates fixed = area_of(ReferencePoint::Kind::fixed);
  const raster::SceneCoordinates moving = area_of(ReferencePoint::Kind::moving);
  // Along x, the flight: lambda/2 over the angle of 120 m in 2 915 m; the targets span 21 m.
  const double cell_m = 0.5 * light_mps / 9.6e9 / (120.0 / 2915.0);
  EXPECT_NEAR(moving.area.x2 - moving.area.x1, 1.2 * 21.0 + 16.0 * cell_m, 1.5 * cell_m);
  EXPECT_NEAR(moving.area.x2 - moving.area.x1, fixed.area.x2 - fixed.area.x1, 1e-6);
  EXPECT_NEAR(moving.area.y2 - moving.area.y1, fixed.area.y2 - fixed.area.y1, 1e-6);
}

TEST(ExportCphd, LaysThePlaneOnTheEarth) {
  const SmallScene scene;
  core::Problems heard;
  ExportRequest request = scene.request("plane.cphd");
  request.anchor.reset();
  EXPECT_THAT(refusal_of(request), HasSubstr("give --anchor LATITUDE,LONGITUDE,HEIGHT"));
  constexpr double degree = core::pi / 180.0;
  request.anchor = radar::Anchor{{47.5 * degree, 8.25 * degree, 400.0}, 90.0 * degree};
  export_recording(request, hears(heard));
  EXPECT_THAT(words_of(heard), HasSubstr("the scene has no epoch: CPHD is dated 2000-01-01"));
  const WholeFile file = whole_of(request.output);
  const radar::Geodetic place = radar::geodetic_of(file.d.scene.origin_m);
  EXPECT_NEAR(place.latitude_rad * 180.0 / core::pi, 47.5, 1e-3);
  EXPECT_NEAR(place.longitude_rad * 180.0 / core::pi, 8.25, 1e-3);
  EXPECT_NEAR(place.height_m, 400.67, 0.01) << "the targets are 0, 0 and 2 m high";
}

TEST(ExportCphd, WarnsOfHardEdges) {
  const SmallScene scene;
  core::Problems heard;
  ExportRequest request = scene.request("hard.cphd");
  request.input.overrides.pulse = scene::PulseDefinition::ideal;
  export_recording(request, hears(heard));
  EXPECT_THAT(words_of(heard), HasSubstr("rms errors of 3 to 7 %"));
}

TEST(ExportCphd, RefusesWhatCannotBe) {
  const SmallScene scene;
  const auto changed = [&](const std::string& old, const std::string& now) {
    std::string text = scene_text;
    text.replace(text.find(old), old.size(), now);
    scene.write(text);
    return refusal_of(scene.request("bad.cphd"));
  };
  EXPECT_THAT(changed(R"({ type = "chirp", bandwidth = "60 MHz", width = "0.5 us" })",
                      R"({ type = "barker", length = 2, width = "0.5 us" })"),
              HasSubstr("the spectrum of the pulse has gaps"));
  EXPECT_THAT(changed("velocity = [100, 0, 0]", "velocity = [0, 0, 0]"), HasSubstr("the antenna does not move"));
  scene.write(scene_text);
  ExportRequest request = scene.request("bad.cphd");
  request.input.overrides.profile = scene::Profile::classic;
  EXPECT_THAT(refusal_of(request), HasSubstr("the classic profile has another speed of light"));
  request = scene.request("small.toml");
  EXPECT_THAT(refusal_of(request), HasSubstr("small.toml"));
  for (const char* text : {"here", "1,2", "1,2,x", "1,2,3,4", ""})
    EXPECT_THROW(static_cast<void>(reference_point_from(text)), core::InvalidRequest) << text;
  EXPECT_FALSE(fs::exists(scene.folder / "bad.cphd"));
}

TEST(ExportCrsd, HasTheLayoutOfTheStandard) {
  const SmallScene scene;
  ExportRequest request = scene.request("a.crsd");
  request.encoding = raster::SignalEncoding::ci4;
  export_recording(request, {});
  const std::string bytes = bytes_of(request.output);
  EXPECT_TRUE(bytes.starts_with("CRSDsar/1.0\nXML_BLOCK_SIZE := "));
  auto input = core::InputFile::open(request.output);
  const auto header = raster::read_block_header(std::get<core::InputFile>(input));
  ASSERT_TRUE(header);
  std::uint64_t end = 0;
  for (const char* name : {"XML", "SUPPORT", "PPP", "PVP", "SIGNAL"}) {
    const auto block = header->block(name);
    ASSERT_TRUE(block) << name;
    EXPECT_GE(block->offset, end) << name;
    EXPECT_EQ(block->offset % 64, 0U) << name;
    end = block->offset + block->bytes;
  }
  EXPECT_EQ(end, bytes.size());
  EXPECT_EQ(header->block("SUPPORT")->bytes, 96U);
  EXPECT_EQ(header->block("PPP")->bytes, 145U * 200U);
  EXPECT_EQ(header->block("PVP")->bytes, 145U * 216U);
  ExportRequest many = scene.request("a.crsd");
  many.encoding = request.encoding;
  many.threads = 5;
  export_recording(many, {});
  EXPECT_EQ(bytes_of(many.output), bytes);
}

TEST(ExportCrsd, RefusesWhatLeavesTheClockOfTheConverter) {
  const SmallScene scene;
  const auto changed = [&](const std::string& old, const std::string& now) {
    std::string text = scene_text;
    text.replace(text.find(old), old.size(), now);
    scene.write(text);
    return refusal_of(scene.request("bad.crsd"));
  };
  EXPECT_THAT(changed("120 Hz", "123.456789 Hz"), HasSubstr("a repetition of 123.456"));
  EXPECT_THAT(changed("75 MHz", "65 MHz"), HasSubstr("at least 66 MHz, 1.1 times the bandwidth"));
  EXPECT_THAT(changed(R"(range = ["2850 m", "3000 m"])", R"(range = ["2850 m", "1300 km"])"),
              HasSubstr("the recorded windows overlap"));
  EXPECT_THAT(changed(R"({ type = "chirp", bandwidth = "60 MHz", width = "0.5 us" })",
                      R"({ type = "barker", length = 13, width = "0.5 us" })"),
              HasSubstr("CRSD describes pulses of one frequency and chirps"));
}

}  // namespace sarsim::workflow::export_test
