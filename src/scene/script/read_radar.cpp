#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scene/script/read_commands.hpp"

namespace sarsim::scene::script {

namespace {

bool is_antenna(std::string_view word) {
  const auto& patterns = field_of<&Radar::transmit_antenna, &Antenna::pattern>().spec.choices;
  return std::ranges::any_of(patterns, [&](const Choice& pattern) { return keyword_matches(word, pattern.word); });
}

// How many values stand before the transmit antenna: two (losses, noise), or four with the gains that the 2015 program
// added. Where no antenna follows soon, only what looks like a number counts.
std::size_t values_before_antenna(const FieldReader& reader) {
  constexpr std::size_t far_enough = 8;
  Tokens ahead = reader.tokens();
  std::size_t numbers = 0;
  bool only_numbers = true;
  for (std::size_t values = 0; values < far_enough && ahead.peek().is_value(); ++values) {
    const Token token = ahead.take();
    if (is_antenna(token.text)) return values;
    only_numbers = only_numbers && begins_like_number(token.text);
    if (only_numbers) ++numbers;
  }
  return numbers >= 4 ? 4 : 2;
}

void read_gains_and_losses(FieldReader& reader, Radar& radar) {
  const std::size_t values = reader.more() ? values_before_antenna(reader) : 2;
  if (values == 3 || values > 4) {
    reader.pass_over(
        field_of<&Radar::losses>().in_script, values,
        {fmt::format("{} values between the power and the transmit antenna", values), shown(reader.peek().text),
         "2 (losses in dB, noise temperature in K), or 4 (gains of transmitter and receiver in dB first)"});
    return;
  }
  if (values == 4) reader.read(radar_order().gains, radar);
  reader.read(radar_order().losses, radar);
}

// The receive antenna has the patterns of the transmit antenna, or SAME before the last of them.
void read_receive_antenna(FieldReader& reader, Radar& radar) {
  const auto& pattern = field_of<&Radar::receive_antenna, &Antenna::pattern>();
  std::vector<Choice> choices = pattern.spec.choices;
  const std::size_t same = choices.size() - 1;
  const auto& same_choices = field_of<&Radar::same_antenna>().spec.choices;
  choices.insert(choices.end() - 1, same_choices.begin(), same_choices.end());
  std::vector<std::string_view> words;
  for (const Choice& choice : choices) words.push_back(choice.word);
  const std::size_t at = reader.keyword(pattern.in_script, words);
  radar.same_antenna = at == words.size() || at == same;
  if (!radar.same_antenna) pattern.put(radar, choices[at].value);
  reader.read(radar_order().receive_antenna, radar);
}

// NO_STC, or APPLY_STC and the law.
void read_stc(FieldReader& reader, Radar& radar) {
  const auto& stc = field_of<&Radar::stc>();
  const auto& laws = stc.spec.choices;
  if (reader.keyword(stc.in_script, std::array{laws[0].word, stc_switch}) != 1) return;
  Field law = stc.in_script;
  law.words = "law of the sensitivity-time control";
  const std::size_t at = reader.keyword(law, std::array{laws[1].word, laws[2].word});
  stc.put(radar, laws[at == 1 ? 2 : 1].value);
  reader.read(radar_order().stc, radar);
}

}  // namespace

void read_radar(Reading& reading, const Token& command, Scene& scene) {
  FieldReader reader(reading, command, "radar", scene.radars.size());
  Radar radar;
  if (reader.leading_name(field_of<&Radar::name>().in_script, radar.name)) {
    reader.read(radar_order().up_to_power, radar);
    read_gains_and_losses(reader, radar);
    reader.read(radar_order().transmit_antenna, radar);
    read_receive_antenna(reader, radar);
    reader.read(radar_order().direction_and_window, radar);
    read_stc(reader, radar);
    scene.radars.push_back(std::move(radar));
  }
  reader.finish();
}

}  // namespace sarsim::scene::script
