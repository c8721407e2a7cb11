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
    for (const scene::Platform& p : scene.platforms) {
      if (p.read_path) add_states(*p.read_path);
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
  // The motion itself, at times all over the file.
  void add_states(const scene::ReadPath& path) {
    constexpr double steps = 64.0;
    const double span_s = path.usable.last_s - path.usable.first_s;
    for (double step = 0.0; step <= steps; step += 1.0)
      if (const auto motion = path.states->at(path.usable.first_s + step / steps * span_s))
        sum_.add(std::as_bytes(std::span(&*motion, 1)));
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
  constexpr std::size_t most_rows = 64;
  core::Checksum sum;
  file.wait_until_indexed(stop);
  const std::size_t rows = file.rows();
  const std::uint64_t shape[] = {rows, file.columns()};
  sum.add(std::as_bytes(std::span(shape)));
  std::vector<std::complex<double>> row(file.columns());
  const std::size_t count = std::min(rows, most_rows);
  for (std::size_t i = 0; i < count; ++i) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    file.read_rows(count > 1 ? i * (rows - 1) / (count - 1) : 0, 1, row);
    sum.add(std::as_bytes(std::span(row)));
  }
  return fmt::format("{:016x}", sum.value());
}

}  // namespace sarsim::workflow
