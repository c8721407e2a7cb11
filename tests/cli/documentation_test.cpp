#include <regex>
#include <set>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace documentation_test {

using testing::HasSubstr;

const std::vector<std::string> commands{"run",      "sweep",   "check",   "info",   "geometry", "convert", "plot",
                                        "focus",    "measure", "doppler", "search", "format",   "verify",  "completion",
                                        "profiles", "isar",    "merge",   "new",    "explain",  "motion"};

class Documentation : public CommandTest {
 protected:
  // Every long option that the helps show.
  [[nodiscard]] std::set<std::string> options_of(const std::vector<std::string>& names) const {
    std::set<std::string> options;
    for (const std::string& name : names) {
      const std::string help =
          sarsim(name.empty() ? std::vector<std::string>{"--help"} : std::vector<std::string>{name, "--help"}).out;
      const std::string listed = help.substr(0, help.find("Examples:"));
      const std::regex pattern("--[a-z][a-z-]*");
      for (std::sregex_iterator i(listed.begin(), listed.end(), pattern), end; i != end; ++i) options.insert(i->str());
    }
    return options;
  }

  [[nodiscard]] std::set<std::string> all_options() const {
    std::vector<std::string> names = commands;
    names.emplace_back();
    return options_of(names);
  }
};

TEST_F(Documentation, ManualPageNamesEveryCommandAndOption) {
  const std::string page = std::regex_replace(text_of(SARSIM_SOURCE_DIR "/docs/sarsim.1"), std::regex("\\\\-"), "-");
  for (const std::string& command : commands) EXPECT_THAT(page, HasSubstr("sarsim " + command)) << command;
  ASSERT_GT(all_options().size(), 20U);
  for (const std::string& option : all_options()) EXPECT_THAT(page, HasSubstr(option));
}

TEST_F(Documentation, GuideNamesEveryCommandAndOption) {
  const std::string page = text_of(SARSIM_SOURCE_DIR "/docs/guide/commands.md");
  for (const std::string& command : commands) EXPECT_THAT(page, HasSubstr("## sarsim " + command));
  for (const std::string& option : all_options()) EXPECT_THAT(page, HasSubstr("`" + option));
}

TEST_F(Documentation, DocumentsNameNoOptionThatDoesNotExist) {
  const std::set<std::string> options = all_options();
  const std::string manual = std::regex_replace(text_of(SARSIM_SOURCE_DIR "/docs/sarsim.1"), std::regex("\\\\-"), "-");
  const std::string pages = manual + text_of(SARSIM_SOURCE_DIR "/docs/guide/commands.md");
  const std::regex pattern("--[a-z][a-z-]*");
  for (std::sregex_iterator i(pages.begin(), pages.end(), pattern), end; i != end; ++i)
    EXPECT_TRUE(options.contains(i->str())) << i->str();
}

TEST_F(Documentation, CompletionsHoldEveryCommandAndOption) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Finished completion = sarsim({"completion", shell});
    EXPECT_EQ(completion.status, 0);
    for (const std::string& command : commands) EXPECT_THAT(completion.out, HasSubstr(command)) << shell;
    for (const std::string& option : all_options()) {
      const std::string text = std::string(shell) == "fish" ? " -l " + option.substr(2) + " " : option;
      EXPECT_THAT(completion.out, HasSubstr(text)) << shell;
    }
  }
}

TEST_F(Documentation, BashCompletesCommandsOptionsAndChoices) {
  write_text(folder_ / "complete.sh",
             "eval \"$('" SARSIM_PROGRAM
             "' completion bash)\"\n"
             "try() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _sarsim; echo \"${COMPREPLY[*]}\"; }\n"
             "try sarsim ch\ntry sarsim run --thr\ntry sarsim run --format h\ntry sarsim completion f\n");
  const std::string command = "cd '" + folder_.string() + "' && bash complete.sh > answers 2> errors";
  ASSERT_EQ(std::system(command.c_str()), 0) << text_of(folder_ / "errors");
  EXPECT_EQ(text_of(folder_ / "answers"), "check\n--threads\nhdf5\nfish\n");
}

}  // namespace documentation_test
}  // namespace sarsim::test
