#include "workflow/options/trade_options.hpp"

#include <algorithm>

#include "core/text/letters.hpp"
#include "scene/schema/trade_words.hpp"

namespace sarsim::workflow {

namespace {

// A word for a choice of an option.
struct ChoiceWord {
  std::string_view names;  // parted by blanks
  std::string_view option;
  std::string_view choice;  // empty: there is none, and `note` says what to do
  std::string_view note = {};
};

constexpr ChoiceWord choice_words[] = {
    {"bp bpa gbp tdbp backprojection back_projection time_domain", "--algorithm", "back-projection"},
    {"rd rda rangedoppler range_doppler", "--algorithm", "range-doppler"},
    {"cs csa chirpscaling chirp_scaling", "--algorithm", "chirp-scaling"},
    {"wk wka omegak omega_k w_k rma stolt wavenumber range_migration", "--algorithm", "omega-k"},
    {"pfa polar_format", "--algorithm", "",
     "polar format is not among them: omega-k focuses spotlights, too, and back-projection any flight"},
    {"image sar focused slc", "--kind", "", "sarsim focus makes an image; sarsim plot IMAGE -o FILE.png draws it"},
    {"range_doppler rd rdm doppler_map", "--kind", "doppler"},
    {"isar", "--kind", "", "sarsim isar makes an image; sarsim plot IMAGE -o FILE.png draws it"},
    {"ppi", "--kind", "", "sarsim search draws it"},
};

// A word that is no option, command or argument.
struct OtherWord {
  std::string_view names;    // as they are typed, parted by blanks
  std::string_view command;  // empty: in place of a command; "*": in all
  std::string_view note;
};

constexpr OtherWord other_words[] = {
    {"version -v -V ver", "", "sarsim --version prints it"},
    {"simulate sim record", "", "sarsim run SCENE records"},
    {"image process", "", "sarsim focus RECORDING makes an image"},
    {"view show", "", "sarsim plot FILE -o FILE.png draws it, sarsim-gui shows it"},
    {"--method --algo --processor", "focus", "did you mean '--algorithm'?"},
    {"--out -o --output", "measure", "--csv and --json write to standard output: sarsim measure IMAGE --csv > FILE"},
    {"--gpu --cuda --device", "*", "everything is computed on processors; --threads says on how many cores"},
};

std::string folded(std::string_view text) {
  std::string made;
  for (const char c : text)
    if (c != '_' && c != '-' && c != ' ') made += core::lower(c);
  return made;
}

// Whether one of the names is a word, both by `form`.
template <class Form>
bool names_word(std::string_view names, std::string_view word, const Form& form) {
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(' '), names.size());
    if (form(names.substr(0, end)) == form(word)) return true;
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return false;
}

const ChoiceWord* choice_word(std::string_view option, std::string_view word) {
  const auto found = std::ranges::find_if(
      choice_words, [&](const ChoiceWord& one) { return one.option == option && names_word(one.names, word, folded); });
  return found == std::end(choice_words) ? nullptr : &*found;
}

// Formats have the words that scenes know for them.
const scene::TradeChoice* format_word(std::string_view option, std::string_view word) {
  return option == "--format" || option == "--to" ? scene::trade_choice(word, "format") : nullptr;
}

}  // namespace

std::string meant_choice(std::string_view option, const std::string& word, const std::vector<std::string>& choices) {
  std::string_view meant;
  if (const ChoiceWord* const known = choice_word(option, word)) meant = known->choice;
  if (const scene::TradeChoice* const format = format_word(option, word)) meant = format->word;
  return std::ranges::find(choices, meant) == choices.end() ? std::string() : std::string(meant);
}

std::string_view other_way_than_choice(std::string_view option, std::string_view word) {
  if (const ChoiceWord* const known = choice_word(option, word)) return known->note;
  const scene::TradeChoice* const format = format_word(option, word);
  return format != nullptr ? format->note : std::string_view();
}

std::string_view other_way_than_word(std::string_view command, std::string_view word) {
  const auto same = [](std::string_view text) { return text; };
  const auto found = std::ranges::find_if(other_words, [&](const OtherWord& one) {
    return (one.command == command || (one.command == "*" && !command.empty())) && names_word(one.names, word, same);
  });
  return found == std::end(other_words) ? std::string_view() : found->note;
}

}  // namespace sarsim::workflow
