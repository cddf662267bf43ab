#include "core/measure/preset_difference.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace airlight::measure {
namespace {

TEST(PresetDifference, ListsLeavesByPointer) {
  const auto differences =
      preset_difference(R"({"sun":{"elevation_deg":20},"media":[{"g":0.8},{"g":0.1}],"name":"x"})",
                        R"({"sun":{"elevation_deg":20.0},"media":[{"g":0.76}],"name":"y","extra":[1]})");
  ASSERT_EQ(differences.size(), 4U);
  EXPECT_EQ(differences[0].pointer, "/extra/0");
  EXPECT_EQ(differences[0].a, "");
  EXPECT_EQ(differences[0].b, "1");
  EXPECT_EQ(differences[1].pointer, "/media/0/g");
  EXPECT_EQ(differences[1].a, "0.8");
  EXPECT_EQ(differences[1].b, "0.76");
  EXPECT_EQ(differences[2].pointer, "/media/1/g");
  EXPECT_EQ(differences[2].b, "");
  EXPECT_EQ(differences[3].pointer, "/name");
  EXPECT_EQ(differences[3].a, "\"x\"");
}

TEST(PresetDifference, EqualPresetsHaveNone) {
  EXPECT_TRUE(preset_difference(R"({"a":{"b":[1,2]}})", R"({ "a" : {"b":[1, 2.0]} })").empty());
}

TEST(PresetDifference, RefusesWhatIsNotJson) {
  EXPECT_THROW(preset_difference("{", "{}"), InputError);
}

}  // namespace
}  // namespace airlight::measure
