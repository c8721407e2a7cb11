#include "workflow/input/script_sum.hpp"

#include <algorithm>
#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "core/hash/checksum.hpp"
#include "scene/language/recorded_text.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/read_path.hpp"

namespace sarsim::workflow {

namespace {

// The points of functions that the script only names the file of.
class DataFiles {
 public:
  explicit DataFiles(core::Checksum& sum) : sum_(sum) {}

  template <std::size_t N>
  void add(const scene::UserFunction<N>& function) {
    if (function.file.empty()) return;
    for (const core::SampledFunction& part : function.part) sum_.add(std::as_bytes(std::span(part.knots)));
  }

  void add(const scene::Scene& scene) {
    const radar::TimeSpan needed = scene::needed_times(scene);
    for (const scene::Platform& p : scene.platforms) {
      add_motion(p, needed);
      add(p.trajectory_m);
      add(p.rotation_deg);
      add(p.position_envelope);
      add(p.rotation_envelope);
    }
    for (const scene::Target& target : scene.targets) add(target.traits->gain_db);
    for (const scene::Cloud& cloud : scene.clouds) {
      add(cloud.traits.gain_db);
      if (cloud.points) sum_.add(std::as_bytes(std::span(&cloud.points->sum, 1)));
    }
    for (const scene::Radar& r : scene.radars) {
      add(r.pulse_iq);
      add(r.envelope_gain);
      add(r.pri_s);
      add(r.carrier_list_hz);
      add(r.transmit_antenna.gain_db);
      add(r.receive_antenna.gain_db);
      add(r.beam_target_world_m);
      add(r.window_gain);
      add(r.stc_gain);
    }
  }

 private:
  // The motion itself, at times all over the file and closely where the scene needs it: states count for some samples
  // around them, so that a change of any of those that echoes depend on is met.
  void add_motion(const scene::Platform& platform, const radar::TimeSpan& needed) {
    if (platform.read_path) {
      const scene::ReadPath& path = *platform.read_path;
      at_times(path.usable, needed, [&](double time_s) {
        if (const auto motion = path.states->at(time_s)) sum_.add(std::as_bytes(std::span(&*motion, 1)));
      });
    }
    if (platform.read_attitude) {
      const scene::ReadAttitude& attitude = *platform.read_attitude;
      at_times(attitude.usable, needed, [&](double time_s) {
        const radar::TurningMatrix turning = attitude.attitudes->turning_at(time_s);
        sum_.add(std::as_bytes(std::span(&turning, 1)));
      });
    }
  }

  template <class Take>
  static void at_times(const radar::TimeSpan& usable, const radar::TimeSpan& needed, const Take& take) {
    const auto over = [&](double first_s, double last_s, int steps) {
      for (int step = 0; step <= steps && first_s <= last_s; ++step)
        take(first_s + static_cast<double>(step) / static_cast<double>(steps) * (last_s - first_s));
    };
    over(usable.first_s, usable.last_s, 64);
    over(std::max(usable.first_s, needed.first_s), std::min(usable.last_s, needed.last_s), 1 << 14);
  }

  core::Checksum& sum_;
};

}  // namespace

std::string script_sum(const scene::Scene& scene, const core::WorkControl& control) {
  core::Checksum sum;
  scene::recorded_text(scene, control, [&](std::string_view piece) { sum.add(piece); });
  DataFiles(sum).add(scene);
  return fmt::format("{:016x}", sum.value());
}

std::string samples_sum(const raster::Raster& file, const core::StopFlag* stop) {
  constexpr std::size_t max_rows = 64;
  core::Checksum sum;
  file.wait_until_indexed(stop);
  const std::size_t rows = file.rows();
  const std::uint64_t shape[] = {rows, file.columns()};
  sum.add(std::as_bytes(std::span(shape)));
  std::vector<std::complex<double>> row(file.columns());
  const std::size_t count = std::min(rows, max_rows);
  for (std::size_t i = 0; i < count; ++i) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    file.read_rows(count > 1 ? i * (rows - 1) / (count - 1) : 0, 1, row);
    sum.add(std::as_bytes(std::span(row)));
  }
  return fmt::format("{:016x}", sum.value());
}

}  // namespace sarsim::workflow
