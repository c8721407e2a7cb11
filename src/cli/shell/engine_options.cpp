#include "cli/shell/engine_options.hpp"

#include "cli/shell/context.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace sarsim::cli {

CLI::Option* add_engine(CLI::App& app, std::optional<simulate::Engine>& engine, const std::string& description) {
  return add_choice<simulate::Engine>(app, "--engine", engine,
                                      {{"auto", simulate::Engine::automatic},
                                       {"direct", simulate::Engine::direct},
                                       {"spectral", simulate::Engine::spectral},
                                       {"reference", simulate::Engine::reference}},
                                      description);
}

void choose_simd(const std::string& level) {
  if (level.empty() || simulate::use_simd_level(level)) return;
  std::string levels;
  for (const std::string& known : simulate::simd_levels()) levels += (levels.empty() ? "" : ", ") + known;
  throw core::Refused("--simd: this processor has no '" + level + "'", "choose among " + levels);
}

}  // namespace sarsim::cli
