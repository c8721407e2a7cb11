#include "scene/schema/trade_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "core/maths/constants.hpp"

namespace sarsim::scene {
namespace trade_words_test {

using testing::HasSubstr;
using testing::StartsWith;

std::size_t spellings_in(std::string_view names) {
  std::size_t count = names.empty() ? 0 : 1;
  for (const char c : names) count += c == ' ' ? 1 : 0;
  return count;
}

TEST(TradeWords, AreMoreThanEightyThings) {
  std::size_t spellings = 0;
  for (const TradeWord& word : trade_words()) spellings += spellings_in(word.names);
  EXPECT_GE(trade_words().size(), 80U);
  EXPECT_GE(spellings, 400U);
}

TEST(TradeWords, AreEachFoundAndMeanOneThingInAKind) {
  std::set<std::pair<std::string, std::string>> met;
  for (const TradeWord& word : trade_words()) {
    EXPECT_FALSE(word.line.empty() && word.note.empty()) << word.names;
    std::string_view names = word.names;
    while (!names.empty()) {
      const std::size_t end = std::min(names.find(' '), names.size());
      const std::string name(names.substr(0, end));
      names.remove_prefix(std::min(end + 1, names.size()));
      EXPECT_EQ(trade_word(name, word.kind.empty() ? "no kind" : word.kind), &word) << name << " in " << word.kind;
      EXPECT_TRUE(met.emplace(name, word.kind).second) << name << " twice in " << word.kind;
    }
  }
}

struct Advice {
  TradeUse use;
  std::string says;
};

TEST(TradeWords, AreConvertedAsRadarPeopleMeanThem) {
  const Advice rows[]{
      {{"wavelength", "radar", "3 cm", {}}, "write carrier = \"9.993 GHz\" (c/wavelength)"},
      {{"lambda", "radar", "0.03", {}}, "write carrier = \"9.993 GHz\" (c/wavelength)"},
      {{"lambda_cm", "radar", "3", {}}, "write carrier = \"9.993 GHz\" (c/wavelength)"},
      {{"PRI", "radar", "1 ms", {}}, "write repetition = \"1 kHz\" (the PRF is 1/PRI)"},
      {{"pri_us", "radar", "500", {}}, "write repetition = \"2 kHz\""},
      {{"prf", "radar", "1.2 kHz", {}}, "write repetition = \"1.2 kHz\""},
      {{"fc", "radar", "9.6e9", {}}, "write carrier = \"9.6e9\""},
      {{"center_frequency_ghz", "radar", "9.6", {}}, "write carrier = \"9.6 GHz\""},
      {{"OperatingFrequency", "radar", "10 GHz", {}}, "write carrier = \"10 GHz\""},
      {{"noise_figure", "radar", "3 dB", {}}, "write noise_temperature = \"578.6 K\""},
      {{"nf_db", "radar", "0", {}}, "write noise_temperature = \"290 K\""},
      {{"scan_period", "radar", "5 s", {}}, "rate = \"72 deg/s\""},
      {{"look_angle", "radar", "35 deg", {}}, "elevation = \"-55 deg\""},
      {{"depression_angle", "radar", "20 deg", {}}, "elevation = \"-20 deg\""},
      {{"range_resolution", "radar", "1.5 m", {}}, "bandwidth = \"99.93 MHz\""},
      {{"fs", "radar", "60 MHz", {}}, "write sample_rate = \"60 MHz\" in [[recording]]"},
      {{"fs", "recording", "60 MHz", {}}, "write sample_rate = \"60 MHz\""},
      {{"range_bin", "recording", "2.5 m", {}}, "write sample_rate = \"59.96 MHz\""},
      {{"antenna_length", "radar", "2 m", 5.3e9}, "azimuth_width = \"1.436 deg\""},
      {{"velocity", "target", "10 m/s", {}}, "objects move with their platform"},
      {{"velocity", "platform", "120 m/s", {}}, "velocity = [\"120 m/s\", 0, 0]"},
      {{"velocity", "platform", "[60, 0, 0]", {}, true}, "write velocity = [60, 0, 0] in path"},
      {{"velocity", "platform", "60 m/s", {}, true}, "velocity = [\"60 m/s\", 0, 0]"},
      {{"sigma", "target", "-10 dB", {}}, "write rcs = \"-10 dBsm\""},
      {{"sigma", "target", "3 m", {}}, "write rcs = \"10 m2\""},
      {{"fs", "recording", "60 MS/s", {}}, "write sample_rate = \"100 MHz\""},
      {{"cpi", "radar", "64", {}}, "write time = [\"0 s\", \"1 s\"] in [[recording]]"},
      {{"cpi", "radar", "20 ms", {}}, "write time = [\"0 s\", \"20 ms\"] in [[recording]]"},
      {{"time_start", "recording", "0", {}}, "write time = [\"0 s\", \"1 s\"]"},
      {{"if_bandwidth", "radar", "10 MHz", {}}, "write sample_rate = \"100 MHz\" in [[recording]]"},
      {{"waypoints", "platform", "[]", {}}, "write path = { type = \"waypoints\", speed ="},
      {{"seed", "radar", "3", {}}, "write seed = 3 in [options]"},
      {{"polarisation", "radar", "HH", {}}, "polarisation is not modelled"},
      {{"phase_noise", "radar", "", {}}, "not modelled"},
      {{"pri", "radar", "fast", {}}, "write repetition = \"1 kHz\""},
  };
  for (const Advice& row : rows) {
    const TradeWord* const word = trade_word(row.use.name, row.use.kind);
    ASSERT_NE(word, nullptr) << row.use.name;
    EXPECT_THAT(trade_advice(*word, row.use), HasSubstr(row.says)) << row.use.name;
  }
}

TEST(TradeWords, AreSetUnderTheNameOfTheirField) {
  const auto said = [](const TradeUse& use, std::string_view owner) {
    return trade_setting(*trade_word(use.name, use.kind), use, owner);
  };
  EXPECT_THAT(said({"pri", "radar", "1 ms", {}}, "Radar1"), StartsWith("write Radar1.repetition.frequency=1 kHz"));
  EXPECT_THAT(said({"fs", "radar", "60 MHz", {}}, "Radar1"), StartsWith("it is called recording.sample_rate"));
  EXPECT_THAT(said({"hh", "radar", "1", {}}, "Radar1"), StartsWith("polarisation is not modelled"));
}

TEST(TradeWords, AreNothingWhereTheTradeHasNoSuchWord) {
  for (const char* const word : {"", "colour", "xyzzy", "power_", "_", "a_ghz"})
    EXPECT_EQ(trade_word(word, "radar"), nullptr) << word;
  EXPECT_EQ(trade_word(std::string(1000, 'a'), "radar"), nullptr);
  EXPECT_EQ(trade_choice("chirp", "pulse"), nullptr) << "is the word itself";
  EXPECT_EQ(trade_header("quark"), nullptr);
}

TEST(TradeWords, OfChoicesAndKindsAreFound) {
  ASSERT_NE(trade_choice("LFM", "pulse"), nullptr);
  EXPECT_EQ(trade_choice("linear_FM", "pulse")->word, "chirp");
  EXPECT_EQ(trade_choice("spotlight", "beam")->word, "spot");
  EXPECT_EQ(trade_choice("h5", "format")->word, "hdf5");
  EXPECT_EQ(trade_choice("NetCDF", "format")->word, "hdf5");
  EXPECT_EQ(trade_choice(".nc", "format")->word, "hdf5");
  ASSERT_NE(trade_header("Transmitter"), nullptr);
  EXPECT_EQ(trade_header("simulation")->header, "recording");
}

TEST(ConversionHint, TurnsTheUsualOtherQuantityIntoThatOfTheField) {
  struct Row {
    const char* key;
    Quantity quantity;
    const char* typed;
    Quantity given;
    std::optional<double> carrier_hz;
    const char* says;
  };
  const Row rows[]{
      {"repetition.frequency",
       Quantity::frequency,
       "1.67 ms",
       Quantity::time,
       {},
       "write \"598.8 Hz\", which is 1/(1.67 ms)"},
      {"carrier.frequency",
       Quantity::frequency,
       "3 cm",
       Quantity::length,
       {},
       "write \"9.993 GHz\", which is c/(3 cm)"},
      {"antenna.azimuth_width", Quantity::angle, "1 m", Quantity::length, 9.6e9,
       "write \"1.585 deg\", which is 0.886 wavelength/(1 m)"},
      {"antenna.azimuth_width", Quantity::angle, "1 m", Quantity::length, {}, "it is 0.886 wavelength/(1 m)"},
      {"pulse.width", Quantity::time, "10 MHz", Quantity::frequency, {}, "write \"100 ns\""},
      {"range[1]", Quantity::length, "66.7128190396 us", Quantity::time, {}, "write \"10 km\""},
      {"beam.rate", Quantity::angle_rate, "0.2 Hz", Quantity::frequency, {}, "write \"72 deg/s\""},
      {"noise_temperature", Quantity::temperature, "3 dB", Quantity::ratio_db, {}, "write \"578.6 K\""},
      {"rcs", Quantity::area, "10 dB", Quantity::ratio_db, {}, "write \"10 dBsm\""},
      {"power", Quantity::power, "30 dB", Quantity::ratio_db, {}, "write \"30 dBW\" or \"30 dBm\""},
      {"pulse.width", Quantity::time, "3 K", Quantity::temperature, {}, ""},
  };
  for (const Row& row : rows) {
    const FieldSpec spec{.key = row.key, .quantity = row.quantity};
    const auto given = evaluate(row.typed, row.given, {}).value;
    ASSERT_TRUE(given) << row.typed;
    const std::string hint = conversion_hint(spec, row.typed, {*given, dimension_of(row.given)}, row.carrier_hz);
    EXPECT_THAT(hint, StartsWith(row.says)) << row.key << " " << row.typed;
    EXPECT_EQ(hint.empty(), *row.says == '\0') << hint;
  }
}

}  // namespace trade_words_test
}  // namespace sarsim::scene
