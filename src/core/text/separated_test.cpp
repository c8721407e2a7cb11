#include "core/text/separated.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {
namespace separated_test {

using Pieces = std::vector<std::string_view>;
using Numbers = std::vector<double>;

TEST(Separated, HasOnePieceMoreThanSeparators) {
  EXPECT_EQ(pieces_of("a, b ,\tc d", ','), (Pieces{"a", "b", "c d"}));
  EXPECT_EQ(pieces_of(";;", ';'), (Pieces{"", "", ""}));
  EXPECT_EQ(pieces_of("a,b", ';'), (Pieces{"a,b"}));
  EXPECT_EQ(pieces_of("", ','), (Pieces{""}));
}

TEST(Separated, NumbersAreAllOrNone) {
  EXPECT_EQ(numbers_between_commas("1, -2.5e3 ,0"), (Numbers{1.0, -2500.0, 0.0}));
  for (const char* const text : {"", " ", "1,", ",1", "1,,2", "1;2", "1, x, 2", "nan"})
    EXPECT_FALSE(numbers_between_commas(text)) << text;
}

TEST(Separated, AListMayBeEmptyAndEndInAComma) {
  EXPECT_EQ(numbers_of_list(""), Numbers{});
  EXPECT_EQ(numbers_of_list(" 1, 2,\n"), (Numbers{1.0, 2.0}));
  for (const char* const text : {",", "1,,", "1,x,"}) EXPECT_FALSE(numbers_of_list(text)) << text;
}

}  // namespace separated_test
}  // namespace sarsim::core
