// Images that all scenes and lights of a plan share, and images of few components.

#include <gtest/gtest.h>

#include "core/plan/plan.h"

namespace airlight::test {
namespace {

ImageDesc table(const char* key, bool shared) {
  return {.name = key, .extent = {4, 4, 4}, .key = key, .half = true, .components = 1, .shared = shared};
}

TEST(SharedImage, IsFoundByEveryScene) {
  Plan plan;
  plan.begin_scene({}, " of group 0", "");
  const ImageId first = plan.add_image(table("grid", true));
  plan.add_image(table("colours", false));
  plan.begin_scene({}, " of group 1", "");
  ASSERT_TRUE(plan.shared_image("grid").has_value());
  EXPECT_EQ(*plan.shared_image("grid"), first);
  EXPECT_FALSE(plan.shared_image("colours").has_value());
  EXPECT_FALSE(plan.shared_image("colours of group 0").has_value());
  plan.begin_light({}, " of the moon");
  EXPECT_EQ(plan.shared_image("grid"), first);
  EXPECT_EQ(plan.images()[first.index].name, "grid of group 0");
  EXPECT_EQ(plan.images()[first.index].key, "grid");
}

TEST(SharedImage, HasTheBytesOfItsComponents) {
  ImageDesc image{.extent = {3, 5, 7}, .half = true};
  EXPECT_EQ(image.bytes(), 3U * 5U * 7U * 8U);
  image.components = 2;
  EXPECT_EQ(image.bytes(), 3U * 5U * 7U * 4U);
  image.components = 1;
  EXPECT_EQ(image.bytes(), 3U * 5U * 7U * 2U);
}

}  // namespace
}  // namespace airlight::test
