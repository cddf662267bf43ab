// The check of all that is written.

#include "core/output/finite.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/output/files.h"

namespace airlight::test {
namespace {

TEST(Finite, NamesTheFirstPlace) {
  std::vector<float> values(4 * 6, 1.0F);  // 3 x 2 pixels
  EXPECT_EQ(finite_fault("the table x", values, 3, 4), "");
  values[4 * 4 + 2] = kNan;
  values[4 * 5] = kInfinity;
  EXPECT_EQ(finite_fault("the table x", values, 3, 4),
            "the table x holds 2 values that are not finite, the first at column 1, row 1");
}

}  // namespace
}  // namespace airlight::test
