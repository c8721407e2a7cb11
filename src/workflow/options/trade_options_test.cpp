#include "workflow/options/trade_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "workflow/options/option.hpp"

namespace sarsim::workflow {
namespace trade_options_test {

using testing::HasSubstr;

const std::vector<std::string> algorithms{"auto", "range-doppler", "chirp-scaling", "omega-k", "back-projection"};

std::string said(const std::string& name, const std::vector<std::string>& words, const std::string& word) {
  Option option;
  option.name = name;
  option.kind = OptionKind::choice;
  option.words = words;
  return mistake_in(option, word);
}

TEST(TradeOptions, MeanTheAlgorithmsThatThereAre) {
  for (const auto& [word, meant] :
       {std::pair("bp", "back-projection"), std::pair("BPA", "back-projection"), std::pair("rda", "range-doppler"),
        std::pair("csa", "chirp-scaling"), std::pair("wk", "omega-k"), std::pair("omegaK", "omega-k")}) {
    EXPECT_EQ(meant_choice("--algorithm", word, algorithms), meant);
    EXPECT_THAT(said("--algorithm", algorithms, word), HasSubstr(std::string("; did you mean '") + meant + "'?"));
  }
  EXPECT_EQ(meant_choice("--algorithm", "csa", {"range-doppler", "back-projection"}), "") << "not among them";
  EXPECT_EQ(meant_choice("--window", "bp", algorithms), "");
  EXPECT_THAT(said("--algorithm", algorithms, "pfa"), HasSubstr("polar format is not among them"));
}

TEST(TradeOptions, KnowTheFormatsOfOtherPrograms) {
  const std::vector<std::string> formats{"ascii", "binary", "hdf5", "npy"};
  EXPECT_THAT(said("--format", formats, "matlab"), HasSubstr("; did you mean 'hdf5'? MATLAB reads it with h5read"));
  EXPECT_THAT(said("--to", formats, "complex64"), HasSubstr("did you mean 'npy'?"));
}

TEST(TradeOptions, SayWhatElseThereIs) {
  EXPECT_EQ(other_way_than_word("", "version"), "sarsim --version prints it");
  EXPECT_EQ(other_way_than_word("focus", "--method"), "did you mean '--algorithm'?");
  EXPECT_THAT(std::string(other_way_than_word("run", "--gpu")), HasSubstr("--threads"));
  EXPECT_EQ(other_way_than_word("run", "--method"), "");
}

}  // namespace trade_options_test
}  // namespace sarsim::workflow
