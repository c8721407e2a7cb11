#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/report/problem.hpp"

/// The options of requests, described once for every face that takes them.
namespace sarsim::workflow {

/// What an option takes.
enum class OptionKind {
  flag,    ///< Nothing: it is there or not.
  text,    ///< A name or a text that the request reads; not empty, and no option by mistake.
  texts,   ///< The same, and the option may be given several times.
  number,  ///< A decimal number, finite.
  whole,   ///< A whole number from `low` to `high`.
  choice,  ///< One of `words`, ignoring case.
};

/// An option of a request as people see it.
struct Option {
  std::string name;  ///< "--window".
  OptionKind kind = OptionKind::flag;
  std::string placeholder;  ///< What stands for its word: "WINDOW", "slant|ground"; empty for a flag.
  std::string help;
  std::vector<std::string> words{};  ///< Of a choice.
  std::uint64_t low = 0;             ///< Of a whole number.
  std::uint64_t high = 0;
  bool takes_options = false;  ///< Its text is a line of options: anything may stand in it.
  bool told_late = false;      ///< What is wrong with its word is told after what is wrong with the words of others.
};

/// The words that were given for options, by the names of the options; for a flag, any text. Several words of one
/// option are in the order in which they were given.
using GivenWords = std::multimap<std::string, std::string>;

/// What is wrong with a word for an option: "'x' is not a number"; empty where the option takes it.
[[nodiscard]] std::string mistake_in(const Option& option, const std::string& word);

/// The same as a problem that begins with the option's name.
[[nodiscard]] core::Problem problem_with(const Option& option, const std::string& mistake);

/// What is wrong with words that were given for options, in the order of the options; names of none come first.
[[nodiscard]] core::Problems problems_with(const std::vector<Option>& options, const GivenWords& given);

/// The number that a word stands for, which `mistake_in` has let pass as OptionKind::number.
[[nodiscard]] double number_in(const std::string& word);
/// The same for OptionKind::whole.
[[nodiscard]] std::uint64_t whole_number_in(const std::string& word);
/// The same for OptionKind::choice: its position in `option.words`.
[[nodiscard]] std::size_t choice_in(const Option& option, const std::string& word);

}  // namespace sarsim::workflow
