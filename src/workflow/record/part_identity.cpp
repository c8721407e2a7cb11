#include "workflow/record/part_identity.hpp"

#include "core/build/version.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/option_words.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "workflow/input/scene_words.hpp"
#include "workflow/input/script_sum.hpp"

namespace sarsim::workflow {

namespace {

// Counts up where the same recording gives another file, so that parts of both are never joined: versions of
// development share a number.
constexpr const char* file_layout = "3";

}  // namespace

raster::Identity identity_of(const scene::Scene& scene, std::size_t simulation, const raster::StoredProduct& stored,
                             const core::WorkControl& control) {
  const raster::Product& product = stored.product;
  const scene::RunOptions& options = product.options;
  raster::Identity identity{
      {"program", core::program_version},
      {"layout", file_layout},
      {"simulation", std::to_string(simulation + 1)},
      {"rows", std::to_string(product.rows)},
      {"columns", std::to_string(product.columns)},
      {"format", format_word(stored.options.format)},
      {"--counts", stored.options.counts ? "on" : "off"},
      {"--double", stored.options.doubles ? "on" : "off"},
      {"--header", stored.options.header ? "on" : "off"},
      {"seed", std::to_string(options.seed)},
      {"tolerance", core::format_number(options.tolerance)},
      {"engine", product.engine},
      {"--simd", simulate::simd_level()},
      {"LSB", product.lsb_v > 0.0 ? core::format_number(product.lsb_v) + " V" : "estimated"},
      {"script", script_sum(scene, control)},
  };
  for (auto& option : scene::option_words(options)) identity.push_back(std::move(option));
  return identity;
}

}  // namespace sarsim::workflow
