#include "cli/command/part_identity.hpp"

#include <span>

#include <fmt/format.h>

#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/hash/checksum.hpp"
#include "core/text/number_text.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace sarsim::cli {

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
      add(p.trajectory_m);
      add(p.rotation_deg);
      add(p.position_envelope);
      add(p.rotation_envelope);
    }
    for (const scene::Target& target : scene.targets) add(target.gain_db);
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
  core::Checksum& sum_;
};

}  // namespace

std::string script_sum(const scene::Scene& scene, const std::string& script) {
  core::Checksum sum;
  sum.add(script);
  DataFiles(sum).add(scene);
  return fmt::format("{:016x}", sum.value());
}

raster::Identity identity_of(const scene::Scene& scene, std::size_t simulation, const std::string& script,
                             const raster::StoredProduct& stored) {
  const simulate::Product& product = stored.product;
  const scene::RunOptions& options = product.options;
  return {
      {"program", core::program_version},
      {"simulation", std::to_string(simulation + 1)},
      {"rows", std::to_string(product.rows)},
      {"columns", std::to_string(product.columns)},
      {"format", format_word(stored.options.format)},
      {"--counts", stored.options.counts ? "on" : "off"},
      {"--header", stored.options.header ? "on" : "off"},
      {"seed", std::to_string(options.seed)},
      {"profile", profile_word(options.profile)},
      {"pulse", pulse_word(options.pulse)},
      {"tolerance", core::format_number(options.tolerance)},
      {"engine", product.engine},
      {"--simd", simulate::simd_level()},
      {"LSB", product.lsb_v > 0.0 ? core::format_number(product.lsb_v) + " V" : "estimated"},
      {"script", script_sum(scene, script)},
  };
}

}  // namespace sarsim::cli
