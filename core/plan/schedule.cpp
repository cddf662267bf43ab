// Decides which passes of a plan run, in which order, and where barriers go.

#include <algorithm>
#include <utility>

#include "core/plan/plan.h"

namespace airlight {
namespace {

std::size_t slot(const Plan& plan, ResourceId id) {
  if (const auto* image = std::get_if<ImageId>(&id)) return image->index;
  return plan.images().size() + std::get<BufferId>(id).index;
}

std::size_t slot_count(const Plan& plan) {
  return plan.images().size() + plan.buffers().size();
}

// One flag a slot: whether the host or a later plan reads it, so that it must keep its contents after the run.
std::vector<bool> seen_afterwards(const Plan& plan) {
  std::vector<bool> seen(slot_count(plan), false);
  for (std::size_t i = 0; i < plan.buffers().size(); ++i) {
    seen[plan.images().size() + i] = plan.buffers()[i].host_readable || plan.buffers()[i].carried;
  }
  for (const Plan::Readback& readback : plan.readbacks()) seen[slot(plan, readback.image)] = true;
  return seen;
}

// One flag a slot, over the passes visited backwards so far: which later passes touch a resource.
struct Later {
  std::vector<bool> touched;         // by any pass; scratch counts as touched
  std::vector<bool> touched_in_run;  // by a pass that runs
};

bool must_run(const Plan& plan, const PassDesc& pass, const std::vector<bool>& kept, const std::vector<bool>& seen,
              const Later& later) {
  return std::ranges::any_of(pass.writes, [&](const Binding& write) {
    const std::size_t s = slot(plan, write.resource);
    if (kept[s]) return false;
    const bool only_for_skipped_passes = later.touched[s] && !later.touched_in_run[s];
    return seen[s] || !only_for_skipped_passes;
  });
}

std::vector<bool> run_flags(const Plan& plan, const std::vector<bool>& kept, const std::vector<bool>& seen) {
  std::vector<bool> runs(plan.passes().size());
  Later later{std::vector<bool>(slot_count(plan)), std::vector<bool>(slot_count(plan))};
  for (std::size_t i = 0; i < plan.buffers().size(); ++i) {
    later.touched[plan.images().size() + i] = plan.buffers()[i].scratch;
  }
  for (std::size_t i = plan.passes().size(); i-- > 0;) {
    const PassDesc& pass = plan.passes()[i];
    runs[i] = must_run(plan, pass, kept, seen, later);
    const auto touch = [&](const Binding& binding) {
      later.touched[slot(plan, binding.resource)] = true;
      if (runs[i]) later.touched_in_run[slot(plan, binding.resource)] = true;
    };
    std::ranges::for_each(pass.reads, touch);
    std::ranges::for_each(pass.writes, touch);
  }
  return runs;
}

}  // namespace

std::vector<bool> passes_to_run(const Plan& plan, const IsKept& is_kept) {
  const std::vector<bool> seen = seen_afterwards(plan);
  std::vector<bool> kept(slot_count(plan));
  for (std::uint32_t i = 0; i < plan.images().size(); ++i) {
    kept[i] = !plan.images()[i].key.empty() && is_kept(ImageId{i});
  }
  for (std::uint32_t i = 0; i < plan.buffers().size(); ++i) {
    const BufferDesc& buffer = plan.buffers()[i];
    const bool has_key = !buffer.key.empty() || !buffer.stored.empty();
    kept[plan.images().size() + i] = has_key && !buffer.carried && is_kept(BufferId{i});
  }
  while (true) {
    std::vector<bool> runs = run_flags(plan, kept, seen);
    bool unchanged = true;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (!runs[i]) continue;
      // The pass writes again in place, perhaps over what an earlier pass made: that one has to run as well.
      for (const Binding& write : plan.passes()[i].writes) {
        const std::size_t s = slot(plan, write.resource);
        if (kept[s]) unchanged = false;
        kept[s] = false;
      }
    }
    if (unchanged) return runs;
  }
}

std::vector<Scheduled> schedule(const Plan& plan, const std::vector<bool>& runs) {
  // How many levels must follow a pass that writes a part of a slot, and one that reads it: by the later passes so far.
  std::vector<std::size_t> after_write(kBindingParts * slot_count(plan));
  std::vector<std::size_t> after_read(kBindingParts * slot_count(plan));
  std::vector<std::size_t> following(plan.passes().size());
  std::vector<Scheduled> order;
  const auto for_parts = [&](const std::vector<Binding>& bindings, const auto& visit) {
    for (const Binding& b : bindings) {
      for (std::size_t part = 0; part < kBindingParts; ++part) {
        if ((b.parts >> part & 1U) != 0) visit(kBindingParts * slot(plan, b.resource) + part);
      }
    }
  };
  for (std::size_t i = plan.passes().size(); i-- > 0;) {
    if (!runs[i]) continue;
    const PassDesc& pass = plan.passes()[i];
    std::size_t& own = following[i];
    for_parts(pass.reads, [&](std::size_t part) { own = std::max(own, after_read[part]); });
    for_parts(pass.writes, [&](std::size_t part) { own = std::max(own, after_write[part]); });
    for_parts(pass.reads, [&](std::size_t part) { after_write[part] = std::max(after_write[part], own + 1); });
    for_parts(pass.writes, [&](std::size_t part) { after_read[part] = after_write[part] = own + 1; });
    order.push_back({.pass = i});
  }
  std::ranges::sort(order, {}, [&](const Scheduled& s) { return std::pair(~following[s.pass], s.pass); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    order[k].barrier = following[order[k].pass] != following[order[k - 1].pass];
  }
  return order;
}

}  // namespace airlight
