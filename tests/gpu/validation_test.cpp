// The validation layer reports a mistake, so its silence in other tests has a meaning.

#include <gtest/gtest.h>

#include "core/gpu/device.h"
#include "tests/gpu/gpu_fixture.h"

namespace airlight {
namespace {

TEST(Validation, HearsAMistake) {
  const int before = Executor::validation_message_count();
  const Instance instance(true);
  const Device device(instance, "");
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = 0;  // must be greater
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  VkBuffer buffer = nullptr;
  vkCreateBuffer(device.get(), &info, nullptr, &buffer);
  const BufferHandle owner(device.get(), buffer);
  const int heard = Executor::validation_message_count() - before;
  EXPECT_GE(heard, 1);
  expect_validation_messages(heard);
}

}  // namespace
}  // namespace airlight
