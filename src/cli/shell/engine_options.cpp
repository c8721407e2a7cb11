#include "cli/shell/engine_options.hpp"

namespace sarsim::cli {

CLI::Option* add_engine(CLI::App& app, std::optional<simulate::Engine>& engine, const std::string& description) {
  return add_choice<simulate::Engine>(app, "--engine", engine, simulate::named_engines(), description);
}

}  // namespace sarsim::cli
