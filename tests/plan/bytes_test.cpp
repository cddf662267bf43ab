#include "core/plan/bytes.h"

#include <gtest/gtest.h>

namespace airlight {
namespace {

TEST(Bytes, AreTheSameValuesAtAnyAddress) {
  const std::vector<float> values{1.0F, -2.5F, 3e-30F};
  std::vector<std::byte> bytes = bytes_of(values);
  EXPECT_EQ(values_of<float>(bytes), values);
  bytes.insert(bytes.begin(), std::byte{7});
  EXPECT_EQ(values_of<float>(std::span<const std::byte>(bytes).subspan(1)), values);
  EXPECT_TRUE(values_of<float>({}).empty());
}

}  // namespace
}  // namespace airlight
