#include "core/scene/suggestion.h"

#include <gtest/gtest.h>

#include <vector>

namespace airlight::test {
namespace {

using Names = std::vector<std::string>;

TEST(NearestName, HasTheFewestSlips) {
  EXPECT_EQ(nearest_name("abcdeg", Names({"abcdef", "abcdxy"})), "abcdef");
  EXPECT_EQ(nearest_name("abcdeg", Names({"abcdxy", "abcdef"})), "abcdef");
}

TEST(NearestName, ForgivesLettersSwappedLostAddedAndCase) {
  EXPECT_EQ(nearest_name("tset", Names({"test"})), "test");
  EXPECT_EQ(nearest_name("albdo", Names({"albedo"})), "albedo");
  EXPECT_EQ(nearest_name("albeedo", Names({"albedo"})), "albedo");
  EXPECT_EQ(nearest_name("ALBEDO", Names({"albedo"})), "albedo");
}

TEST(NearestName, ForgivesALeftOutUnit) {
  EXPECT_EQ(nearest_name("altitude", Names({"altitude_km"})), "altitude_km");
  EXPECT_EQ(nearest_name("al", Names({"altitude_km"})), std::nullopt);
}

TEST(NearestName, IsNothingWhenAllAreFar) {
  EXPECT_EQ(nearest_name("zebra", Names({"albedo", "width"})), std::nullopt);
  EXPECT_EQ(nearest_name("", Names({"a"})), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100000, 'x'), Names({std::string(100000, 'x')})), std::nullopt);
}

}  // namespace
}  // namespace airlight::test
