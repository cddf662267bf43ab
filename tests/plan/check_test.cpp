// Plans that check() refuses, and the names in its messages.

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/plan/plan.h"

namespace airlight {
namespace {

std::string refusal(const Plan& plan) {
  try {
    check(plan);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

// A plan with one sound pass; tests then spoil it.
struct Sample {
  Plan plan;
  ImageId table;
  ImageId picture;
  BufferId numbers;

  Sample() {
    table = plan.add_image({.name = "table", .extent = {256, 64}});
    picture = plan.add_image({.name = "picture", .extent = {16, 9}});
    numbers = plan.add_buffer({.name = "numbers", .bytes = 64});
    plan.add_pass({.name = "bake", .shader = "bake_table", .writes = {{"table_out", table}}, .grid = {256, 64}});
  }

  PassDesc march() const {
    return {.shader = "march", .reads = {{"table_lut", table}}, .writes = {{"sky_out", picture}}, .grid = {16, 9}};
  }
};

TEST(Check, TakesASoundPlan) {
  Sample s;
  s.plan.add_pass(s.march());
  s.plan.add_readback(s.picture);
  EXPECT_NO_THROW(check(s.plan));
  EXPECT_NO_THROW(check(Plan()));
}

TEST(Check, RefusesAReadWithoutAProducer) {
  Sample s;
  PassDesc pass = s.march();
  pass.reads.push_back({"numbers", s.numbers});
  s.plan.add_pass(pass);
  EXPECT_EQ(refusal(s.plan), "plan: pass march: buffer numbers is read as numbers, but no earlier pass wrote it");
}

TEST(Check, RefusesAReadBeforeItsProducer) {
  Sample s;
  s.plan.add_pass({.shader = "early", .reads = {{"in", s.picture}}, .writes = {{"out", s.numbers}}, .grid = {1, 1}});
  s.plan.add_pass(s.march());
  EXPECT_EQ(refusal(s.plan), "plan: pass early: image picture is read as in, but no earlier pass wrote it");
}

TEST(Check, TakesContentsOrAKeyForAProducer) {
  Plan plan;
  const BufferId filled =
      plan.add_buffer({.name = "filled", .bytes = 4, .contents = std::vector<std::byte>(4, std::byte{1})});
  const ImageId kept = plan.add_image({.name = "kept", .extent = {4, 4}, .key = "kept of that air"});
  const BufferId out = plan.add_buffer({.name = "out", .bytes = 4});
  plan.add_pass(
      {.shader = "use", .reads = {{"filled", filled}, {"kept", kept}}, .writes = {{"out", out}}, .grid = {1, 1}});
  EXPECT_EQ(refusal(plan), "");
}

TEST(Check, RefusesWhatIsReadAndWritten) {
  Sample s;
  PassDesc pass = s.march();
  pass.writes.push_back({"table_out", s.table});
  s.plan.add_pass(pass);
  EXPECT_EQ(refusal(s.plan),
            "plan: pass march: image table is both read (table_lut) and written (table_out); what is read and written "
            "stands among the writes only");
}

TEST(Check, RefusesTwoWritesOfOneResource) {
  Sample s;
  PassDesc pass = s.march();
  pass.writes.push_back({"again_out", s.picture});
  s.plan.add_pass(pass);
  EXPECT_EQ(refusal(s.plan), "plan: pass march: image picture is written as sky_out and as again_out");
}

TEST(Check, TakesTwoReadsOfOneResource) {
  Sample s;
  PassDesc pass = s.march();
  pass.reads.push_back({"other_lut", s.table});
  s.plan.add_pass(pass);
  EXPECT_EQ(refusal(s.plan), "");
}

TEST(Check, RefusesRepeatedNames) {
  Sample s;
  s.plan.add_buffer({.name = "table", .bytes = 4});
  EXPECT_EQ(refusal(s.plan), "plan: two resources are named table");

  Sample binding;
  PassDesc pass = binding.march();
  pass.writes.push_back({"table_lut", binding.numbers});
  binding.plan.add_pass(pass);
  EXPECT_EQ(refusal(binding.plan), "plan: pass march: two bindings are named table_lut");

  Sample key;
  key.plan.add_image({.name = "one", .key = "same"});
  key.plan.add_image({.name = "two", .key = "same"});
  EXPECT_EQ(refusal(key.plan), "plan: two: another resource has the key same too");

  Sample nameless;
  nameless.plan.add_image({.name = ""});
  EXPECT_EQ(refusal(nameless.plan), "plan: a resource has no name");
}

TEST(Check, RefusesWhatIsEmpty) {
  for (const Extent& grid : {Extent{0, 9, 1}, Extent{16, 0, 1}, Extent{16, 9, 0}}) {
    Sample s;
    PassDesc pass = s.march();
    pass.grid = grid;
    s.plan.add_pass(pass);
    EXPECT_EQ(refusal(s.plan), "plan: pass march: its grid is empty");
  }
  Sample image;
  image.plan.add_image({.name = "flat", .extent = {16, 0}});
  EXPECT_EQ(refusal(image.plan), "plan: image flat is empty");
  Sample buffer;
  buffer.plan.add_buffer({.name = "void"});
  EXPECT_EQ(refusal(buffer.plan), "plan: buffer void is empty");
  Sample writes;
  writes.plan.add_pass({.shader = "idle", .grid = {1, 1}});
  EXPECT_EQ(refusal(writes.plan), "plan: pass idle: it writes nothing");
  Sample shader;
  shader.plan.add_pass({.name = "blank", .writes = {{"out", shader.numbers}}, .grid = {1, 1}});
  EXPECT_EQ(refusal(shader.plan), "plan: pass blank has no shader");
}

TEST(Check, RefusesCountsOfWorkgroupsThatAPassDoesNotRead) {
  const auto counted_at = [](std::uint32_t offset, bool read) {
    Sample s;
    s.plan.add_pass({.shader = "count", .writes = {{"numbers", s.numbers}}, .grid = {16, 1}});
    PassDesc pass = s.march();
    if (read) {
      pass.reads.push_back({"counts", s.numbers});
    }
    pass.groups = {s.numbers, offset};
    s.plan.add_pass(pass);
    return refusal(s.plan);
  };
  EXPECT_EQ(counted_at(52, true), "");
  EXPECT_EQ(counted_at(0, false),
            "plan: pass march: the buffer that counts its workgroups is none of those that it has");
  EXPECT_EQ(counted_at(56, true),
            "plan: pass march: byte 56 of buffer numbers cannot hold its three counts of workgroups");
  EXPECT_EQ(counted_at(2, true),
            "plan: pass march: byte 2 of buffer numbers cannot hold its three counts of workgroups");
}

TEST(Check, RefusesContentsOfAnotherLength) {
  Plan plan;
  plan.add_buffer({.name = "directions", .bytes = 16, .contents = std::vector<std::byte>(12)});
  EXPECT_EQ(refusal(plan), "plan: buffer directions has 12 bytes of contents and is 16 long");
}

TEST(Check, RefusesContentsOfAnImageOf16Bits) {
  Plan plan;
  plan.add_image({.name = "map", .extent = {1, 1, 1}, .half = true, .contents_when_run = [] {
                    return std::vector<std::byte>(16);
                  }});
  EXPECT_EQ(refusal(plan), "plan: image map of 16 bits starts with 32-bit contents");
}

TEST(Check, RefusesUnknownResources) {
  Sample s;
  PassDesc pass = s.march();
  pass.reads[0].resource = ImageId{7};
  s.plan.add_pass(pass);
  EXPECT_EQ(refusal(s.plan), "plan: pass march: table_lut is bound to a resource that the plan lacks");

  Sample buffer;
  PassDesc other = buffer.march();
  other.reads[0].resource = BufferId{7};
  buffer.plan.add_pass(other);
  EXPECT_EQ(refusal(buffer.plan), "plan: pass march: table_lut is bound to a resource that the plan lacks");
}

// Nothing would wait for such a pass.
TEST(Check, RefusesPartsThatNothingHas) {
  for (const std::uint32_t parts : {0U, kAllParts + 1}) {
    Sample s;
    PassDesc pass = s.march();
    pass.writes[0].parts = parts;
    s.plan.add_pass(pass);
    EXPECT_EQ(refusal(s.plan), "plan: pass march: sky_out is bound to no part, or to one that nothing has");
  }
}

TEST(Check, RefusesReadbacksOutOfOrder) {
  Sample unwritten;
  unwritten.plan.add_readback(unwritten.picture);
  EXPECT_EQ(refusal(unwritten.plan), "plan: image picture is read back, but no pass wrote it");

  Sample bound;
  const BufferId copy = bound.plan.add_readback(bound.table);
  bound.plan.add_pass({.shader = "use", .writes = {{"out", copy}}, .grid = {1, 1}});
  EXPECT_EQ(refusal(bound.plan),
            "plan: pass use: out is bound to buffer table readback, which is filled after the last pass");
}

// Two of a kind, whose keys tell them apart already.
TEST(Plan, NamesCanBeToldApart) {
  Plan plan;
  const ImageId first = plan.add_image({.name = "field", .key = "first"});
  plan.tell_apart(" 2");
  const ImageId second = plan.add_image({.name = "field", .key = "second"});
  const BufferId buffer = plan.add_buffer({.name = "cells", .bytes = 4});
  plan.add_pass({.shader = "fill", .writes = {{"out", second}, {"cells", buffer}}});
  plan.tell_apart("");
  plan.add_pass({.shader = "fill", .writes = {{"out", first}}});
  EXPECT_EQ(plan.images()[first.index].name, "field");
  EXPECT_EQ(plan.images()[second.index].name, "field 2");
  EXPECT_EQ(plan.images()[second.index].key, "second");
  EXPECT_EQ(plan.buffers()[buffer.index].name, "cells 2");
  EXPECT_EQ(pass_name(plan.passes()[0]), "fill 2");
  EXPECT_EQ(pass_name(plan.passes()[1]), "fill");
  EXPECT_NO_THROW(check(plan));
}

TEST(Plan, ReadbackIsTightlyPacked) {
  Plan plan;
  const ImageId odd = plan.add_image({.name = "odd", .extent = {13, 7, 3}});
  const BufferId readback = plan.add_readback(odd);
  EXPECT_EQ(plan.buffers()[readback.index].bytes, 13U * 7U * 3U * 16U);
  EXPECT_TRUE(plan.buffers()[readback.index].host_readable);
  const ImageId wide = plan.add_image({.name = "wide", .extent = {65536, 65536}});
  EXPECT_EQ(plan.images()[wide.index].bytes(), std::size_t{65536} * 65536 * 16);
}

}  // namespace
}  // namespace airlight
