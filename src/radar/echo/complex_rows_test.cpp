#include "radar/echo/complex_rows.hpp"

#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace complex_rows_test {

template <class Real>
class ComplexRows : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ComplexRows, Precisions);

// Small whole numbers, so that every product is exact in either precision.
template <class Real>
std::vector<std::complex<Real>> whole_numbers(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> whole(-9, 9);
  std::vector<std::complex<Real>> row(count);
  for (auto& z : row) z = {static_cast<Real>(whole(random)), static_cast<Real>(whole(random))};
  return row;
}

TYPED_TEST(ComplexRows, ProductsAndSumsAreExactForEveryLength) {
  at_every_simd_level([] {
    for (std::size_t count = 0; count <= 41; ++count) {
      const auto a = whole_numbers<TypeParam>(count, 1);
      const auto b = whole_numbers<TypeParam>(count, 2);
      auto sum = whole_numbers<TypeParam>(count, 3);
      const auto before = sum;
      auto product = a;
      add_products<TypeParam>(sum, a, b);
      multiply_by<TypeParam>(product, b);
      ComplexRow row(count, {0.5, -0.25});
      add_row<TypeParam>(row, a);
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(product[i], a[i] * b[i]);
        EXPECT_EQ(sum[i], before[i] + a[i] * b[i]);
        EXPECT_EQ(row[i], std::complex<double>(a[i]) + std::complex(0.5, -0.25));
      }
    }
  });
}

}  // namespace complex_rows_test
}  // namespace sarsim::radar
