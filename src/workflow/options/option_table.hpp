#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/report/invalid_request.hpp"
#include "workflow/options/option.hpp"

namespace sarsim::workflow {

/// An option and how its word gets into a request.
template <class Request>
struct RequestOption : Option {
  /// Takes a word in which `mistake_in` finds nothing; throws core::InvalidRequest where it means nothing to the
  /// request.
  std::function<void(Request&, const std::string&)> take;
};

/// What is wrong with words; `late` is to be told after what is wrong with the request as a whole.
struct TakenProblems {
  core::Problems early;
  core::Problems late;

  [[nodiscard]] bool empty() const { return early.empty() && late.empty(); }
};

/// The options of a request, in the order in which help lists them and in which their words are taken.
///
/// Whatever takes a value (`Take`) is a member of the request, to which it is assigned, or a function of the request
/// and the value.
template <class Request>
class OptionTable {
 public:
  /// Sets a bool to `value`.
  void flag(std::string name, std::string help, bool Request::*member, bool value = true) {
    add({std::move(name), OptionKind::flag, "", std::move(help)},
        [member, value](Request& request, const std::string&) { request.*member = value; });
  }
  /// Takes the word itself.
  template <class Take>
  Option& text(std::string name, std::string placeholder, std::string help, Take take) {
    return add({std::move(name), OptionKind::text, std::move(placeholder), std::move(help)},
               [take](Request& request, const std::string& word) { hand(request, word, take); });
  }
  /// Takes each of the words of an option that may be given several times.
  template <class Take>
  Option& texts(std::string name, std::string placeholder, std::string help, Take take) {
    return add({std::move(name), OptionKind::texts, std::move(placeholder), std::move(help)},
               [take](Request& request, const std::string& word) { take(request, word); });
  }
  /// Takes a double.
  /// @param unit  as the help shows it: "M/S"
  template <class Take>
  Option& number(std::string name, std::string unit, std::string help, Take take) {
    return add({std::move(name), OptionKind::number, std::move(unit), std::move(help)},
               [take](Request& request, const std::string& word) { hand(request, number_in(word), take); });
  }
  /// Takes a std::uint64_t from `low` to `high`.
  template <class Take>
  Option& whole(std::string name, std::uint64_t low, std::uint64_t high, std::string help, Take take) {
    return add({std::move(name), OptionKind::whole, "N", std::move(help), {}, low, high},
               [take](Request& request, const std::string& word) { hand(request, whole_number_in(word), take); });
  }
  /// Takes what one of some words means.
  template <class Value, class Take>
  Option& choice(std::string name, const std::vector<std::pair<std::string, Value>>& choices, std::string help,
                 Take take) {
    Option option{std::move(name), OptionKind::choice, "", std::move(help)};
    std::vector<Value> values;
    for (const auto& [word, value] : choices) {
      option.placeholder += (option.placeholder.empty() ? "" : "|") + word;
      option.words.push_back(word);
      values.push_back(value);
    }
    return add(option, [option, values, take](Request& request, const std::string& word) {
      hand(request, values.at(choice_in(option, word)), take);
    });
  }
  /// Adds the options of a part of the request.
  /// @param part  member that is it, or function that gives a reference to it
  template <class Part, class Where>
  void include(const OptionTable<Part>& table, Where part) {
    for (const RequestOption<Part>& option : table)
      add(option, [take = option.take, part](Request& request, const std::string& word) {
        take(std::invoke(part, request), word);
      });
  }

  [[nodiscard]] auto begin() const { return options_.begin(); }
  [[nodiscard]] auto end() const { return options_.end(); }
  /// The options without what takes them.
  [[nodiscard]] std::vector<Option> options() const { return {options_.begin(), options_.end()}; }

  /// Takes words into a request, each one that can be taken. What is wrong with the others comes back.
  [[nodiscard]] TakenProblems take_words(const GivenWords& given, Request& request) const {
    TakenProblems problems;
    problems.early = problems_with(options(), given);
    for (const RequestOption<Request>& option : options_)
      for (auto [word, last] = given.equal_range(option.name); word != last; ++word) {
        if (!mistake_in(option, word->second).empty()) continue;
        try {
          option.take(request, word->second);
        } catch (const core::InvalidRequest& refused) {
          core::append(option.told_late ? problems.late : problems.early, refused.problems);
        }
      }
    return problems;
  }

 private:
  template <class Value, class Take>
  static void hand(Request& request, const Value& value, const Take& take) {
    if constexpr (std::is_member_object_pointer_v<Take>) {
      using Member = std::remove_reference_t<decltype(request.*take)>;
      if constexpr (std::is_arithmetic_v<Member>)
        request.*take = static_cast<Member>(value);
      else
        request.*take = value;
    } else {
      take(request, value);
    }
  }
  Option& add(Option option, std::function<void(Request&, const std::string&)> take) {
    return options_.emplace_back(RequestOption<Request>{std::move(option), std::move(take)});
  }

  std::vector<RequestOption<Request>> options_;
};

}  // namespace sarsim::workflow
