#include "cli/program/completion.hpp"

#include <memory>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"

namespace sarsim::cli {

Action add_completion(CLI::App& app, const CLI::App& root) {
  enum class Shell { bash, zsh, fish };
  auto shell = std::make_shared<std::optional<Shell>>();
  add_choice<Shell>(app, "shell", *shell, {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}},
                    "which shell")
      ->required();
  add_examples(app, {{"sarsim completion bash > ~/.sarsim-completion", "then source that file in ~/.bashrc"},
                     {"sarsim completion zsh > ~/.zfunc/_sarsim", "with ~/.zfunc in $fpath"},
                     {"sarsim completion fish > ~/.config/fish/completions/sarsim.fish", ""}});
  return [shell, &root](Streams& streams) {
    const auto commands = completed_commands(root);
    switch (**shell) {
      case Shell::bash: write_out(streams, bash_completion(commands)); break;
      case Shell::zsh: write_out(streams, zsh_completion(commands)); break;
      case Shell::fish: write_out(streams, fish_completion(commands)); break;
    }
    return exit_done;
  };
}

}  // namespace sarsim::cli
