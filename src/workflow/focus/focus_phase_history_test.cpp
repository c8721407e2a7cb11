#include "workflow/focus/focus_phase_history.hpp"

#include <gmock/gmock.h>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/cphd/cphd_test_support.hpp"
#include "raster/format/open_raster.hpp"
#include "support/test_folder.hpp"

namespace sarsim::workflow::focus_phase_history_test {

using namespace raster::cphd_test;
using raster::PhaseDomain;
using raster::PhaseVector;
using testing::HasSubstr;

/// A phase history by the formula of the standard, with targets at places of the image area.
struct Ideal {
  raster::CphdDescription d;
  std::vector<core::Vec3> targets_m;  // x, y and height in the area
  bool moving_reference = false;
  double declared_sign = 0.0;  // where it is not the true one

  [[nodiscard]] core::Vec3 ecf(const core::Vec3& place) const {
    return d.scene.origin_m + place.x * d.scene.x_axis + place.y * d.scene.y_axis +
           place.z * core::cross(d.scene.x_axis, d.scene.y_axis);
  }

  [[nodiscard]] PhaseVector vector(std::size_t i) const {
    PhaseVector v = small_vector(d, i);
    const double time_s = v.tx_time_s - 0.5 * d.tx_time2_s;
    v.tx_mps = {0.0, 150.0 * 40.0, 0.0};
    v.tx_m = {6378137.0 + 3000.0, v.tx_mps.y * time_s, -4000.0};
    v.rcv_mps = v.tx_mps;
    v.rcv_m = v.tx_m + 3.3e-5 * v.tx_mps;
    v.rcv_time_s = v.tx_time_s + 3.3e-5;
    if (d.bistatic) v.rcv_m = {6378137.0 + 5000.0, -1500.0 + 60.0 * time_s, 2500.0};
    if (moving_reference) v.srp_m = v.srp_m + core::Vec3{0.0, 20.0 * time_s, 3.0};
    v.toa1_s = -2e-7;
    v.toa2_s = 2e-7;
    if (d.domain == PhaseDomain::toa) {
      v.step = 1.0 / (1.5 * (v.fx2_hz - v.fx1_hz));
      v.first = -0.5 * static_cast<double>(d.channels[0].samples) * v.step;
    }
    return v;
  }

  [[nodiscard]] std::vector<std::complex<double>> samples(const PhaseVector& v) const {
    constexpr double c = core::exact_light_speed_mps;
    std::vector<std::complex<double>> samples(d.channels[0].samples);
    for (const core::Vec3& target : targets_m) {
      const core::Vec3 p = ecf(target);
      const double toa_s = (core::norm(v.tx_m - p) + core::norm(v.rcv_m - p) - v.reference_way_m()) / c;
      for (std::size_t k = 0; k < samples.size(); ++k) {
        const double at = v.first + static_cast<double>(k) * v.step;
        double turns = at * toa_s;
        double level = 1.0;
        if (d.domain == PhaseDomain::toa) {
          const double x = core::pi * (v.fx2_hz - v.fx1_hz) * (at - toa_s);
          level = x == 0.0 ? 1.0 : std::sin(x) / x;
          turns = d.channels[0].centre_hz * toa_s;
        }
        samples[k] += level * std::polar(1.0, d.sign * 2.0 * core::pi * (turns - std::round(turns)));
      }
    }
    return samples;
  }

  void write(const std::filesystem::path& path) const {
    raster::CphdDescription said = d;
    if (declared_sign != 0.0) said.sign = static_cast<int>(declared_sign);
    raster::CphdWriter writer(path, said, true);
    for (std::size_t i = 0; i < d.channels[0].vectors; ++i) {
      const PhaseVector v = vector(i);
      writer.append(encode_vector(v, samples(v), d.encoding));
    }
    writer.finish();
  }
};

Ideal ideal(raster::SignalEncoding encoding = raster::SignalEncoding::cf8) {
  Ideal made{small_description(160, 96, encoding), {{0.0, 0.0, 0.0}, {13.0, -11.0, 0.0}}};
  made.d.fx_max_hz = made.d.fx_min_hz + 95e6;
  made.d.scene.area = {-25.0, -25.0, 25.0, 25.0};
  return made;
}

class FocusCphd : public testing::Test {
 protected:
  FocusReport focused(const Ideal& history) {
    history.write(folder_ / "a.cphd");
    request_.input.path = (folder_ / "a.cphd").string();
    request_.threads = 2;
    return focus(request_, {});
  }
  std::string refusal() {
    try {
      static_cast<void>(focus(request_, {}));
    } catch (const core::InvalidRequest& refused) {
      return core::to_string(refused.problems.front());
    }
    return "nothing was refused";
  }
  // Each target lies within a thirtieth of its cell of 1.6 m by 1.3 m and has the amplitude 1 and the phase of its
  // distance from the flight alone.
  static void expect_targets(const FocusReport& report, const Ideal& history, double level = 0.03) {
    const signal::FocusedImage image = signal::in_memory(report.image);
    for (const core::Vec3& target : history.targets_m) {
      const double row = image.azimuth.index_of(target.x), column = image.range.index_of(target.y);
      std::size_t best_row = 0, best_column = 0;
      double best = 0.0;
      for (std::size_t i = 0; i < image.azimuth.count; ++i)
        for (std::size_t k = 0; k < image.range.count; ++k) {
          if (std::abs(static_cast<double>(i) - row) > 4.0 || std::abs(static_cast<double>(k) - column) > 4.0) continue;
          const double magnitude = std::abs(std::complex<double>(image.values[i * image.range.count + k]));
          if (magnitude > best) std::tie(best, best_row, best_column) = std::tuple(magnitude, i, k);
        }
      EXPECT_LE(std::abs(static_cast<double>(best_row) - row), 0.75);
      EXPECT_LE(std::abs(static_cast<double>(best_column) - column), 0.75);
      EXPECT_GT(best, 0.6) << "no more than half a sample off the peak in either direction";
      EXPECT_LT(best, 1.0 + level);
    }
  }

  test::TestFolder folder_;
  FocusRequest request_;
};

// The file is sound and shown; that its image is empty would be the wrong cause.
TEST_F(FocusCphd, OneVectorMakesNoImage) {
  Ideal history = ideal();
  history.d.channels[0].vectors = 1;
  history.d.channels[0].reference = 0;
  history.d.tx_time2_s = 0.0;
  history.write(folder_ / "a.cphd");
  const raster::OpenedRaster opened = raster::open_raster(raster::Integrity::whole, folder_ / "a.cphd");
  ASSERT_TRUE(opened.raster);
  EXPECT_EQ(opened.raster->rows(), 1U);
  request_.input.path = (folder_ / "a.cphd").string();
  EXPECT_THAT(refusal(), HasSubstr("one pulse makes no image; found '1 of 1 vectors', expected two vectors or more"));
}

TEST_F(FocusCphd, PutsTargetsAtTheirPlaces) {
  for (const raster::SignalEncodingName& entry : raster::signal_encodings) {
    const Ideal history = ideal(entry.encoding);
    expect_targets(focused(history), history);
  }
}

TEST_F(FocusCphd, ReadsTheTimeDomain) {
  Ideal history = ideal();
  history.d.domain = PhaseDomain::toa;
  expect_targets(focused(history), history, 0.1);
}

TEST_F(FocusCphd, FollowsAMovingReferencePoint) {
  Ideal history = ideal();
  history.moving_reference = true;
  history.d.channels[0].srp_fixed = false;
  expect_targets(focused(history), history);
}

TEST_F(FocusCphd, TakesAReceiverElsewhere) {
  Ideal history = ideal();
  history.d.bistatic = true;
  history.d.illuminator = "other";
  expect_targets(focused(history), history);
}

TEST_F(FocusCphd, ObeysTheSignOfTheFileOrOfTheUser) {
  Ideal plus = ideal();
  plus.d.sign = 1;
  expect_targets(focused(plus), plus);
  Ideal wrong = ideal();
  wrong.declared_sign = 1.0;
  request_.sign = -1;
  expect_targets(focused(wrong), wrong);
}

TEST_F(FocusCphd, TakesAPartOfTheArea) {
  const Ideal history = ideal();
  request_.azimuth_area = {5.0, 20.0};
  request_.range_area = {-20.0, -5.0};
  const FocusReport report = focused(history);
  EXPECT_GE(report.image.image.azimuth.first_m, 5.0);
  Ideal one = history;
  one.targets_m = {{13.0, -11.0, 0.0}};
  expect_targets(report, one);
}

TEST_F(FocusCphd, RefusesWhatMeansNothing) {
  static_cast<void>(focused(ideal()));
  request_.channel = "2";
  EXPECT_THAT(refusal(), HasSubstr("the file has no such channel; found '2', expected 1"));
  request_.channel.clear();
  request_.autofocus = true;
  EXPECT_THAT(refusal(), HasSubstr("--autofocus means nothing for"));
  request_.autofocus = false;
  request_.memory_bytes = 1000;
  EXPECT_THAT(refusal(), HasSubstr("may be used"));
  request_.memory_bytes = 0;
  Ideal broken = ideal();
  broken.targets_m = {{NAN, 0.0, 0.0}};
  broken.write(folder_ / "a.cphd");
  EXPECT_THAT(refusal(), HasSubstr("holds a sample that is not a number"));
}

// 1e30 as a float, most significant byte first, and 9.9e27, which is computed with.
TEST_F(FocusCphd, RefusesSamplesThatAreTooLargeToComputeWith) {
  static_cast<void>(focused(ideal()));
  std::string bytes = bytes_of(folder_ / "a.cphd");
  const Opened opened = opened_of(folder_ / "a.cphd");
  const std::uint64_t samples = raster::read_block_header(opened.file->file())->block("SIGNAL").value().offset;
  bytes.replace(samples, 4, "\x71\x49\xF2\xCA");
  std::ofstream(folder_ / "a.cphd", std::ios::binary) << bytes;
  EXPECT_THAT(refusal(), HasSubstr("vector 0 (from 0) holds a sample that is too large to compute with"));
  bytes.replace(samples, 4, "\x6D\xFF\xE8\xB4");
  std::ofstream(folder_ / "a.cphd", std::ios::binary) << bytes;
  EXPECT_EQ(refusal(), "nothing was refused");
}

TEST_F(FocusCphd, WritesTheImageOfThePlaneWithItsPlaceOnTheEarth) {
  request_.output = folder_ / "a.img";
  static_cast<void>(focused(ideal()));
  const std::string header = bytes_of(folder_ / "a.hdr");
  EXPECT_THAT(header, HasSubstr("image plane = {ground grid}"));
  EXPECT_THAT(header, HasSubstr("geo points"));
}

}  // namespace sarsim::workflow::focus_phase_history_test
