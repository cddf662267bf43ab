#include "core/gpu/rotate_loops.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <spirv/unified1/spirv.hpp>
#include <stdexcept>
#include <utility>

namespace airlight {
namespace {

constexpr std::size_t kHeaderWords = 5;  // magic, version, generator, bound, schema
constexpr std::size_t kBound = 3;

using Id = std::uint32_t;
using Instruction = std::vector<std::uint32_t>;
using Block = std::vector<Instruction>;  // from its label to the branch at its end
using Blocks = std::vector<Block>;

spv::Op op_of(const Instruction& of) {
  return static_cast<spv::Op>(of[0] & spv::OpCodeMask);
}

Instruction instruction(spv::Op op, std::vector<std::uint32_t> operands) {
  operands.insert(operands.begin(),
                  (static_cast<std::uint32_t>(operands.size() + 1) << spv::WordCountShift) | static_cast<unsigned>(op));
  return operands;
}

Id label_of(const Block& block) {
  return block.front()[1];
}

const Instruction* find(const Block& block, spv::Op op) {
  const auto found = std::ranges::find(block, op, op_of);
  return found == block.end() ? nullptr : &*found;
}

// The words of a branch that are labels.
std::span<std::uint32_t> targets(Instruction& branch) {
  const std::span<std::uint32_t> words(branch);
  switch (op_of(branch)) {
    case spv::OpBranch:
      return words.subspan(1);
    case spv::OpBranchConditional:
      return words.subspan(2, 2);
    case spv::OpSwitch:  // literals among them are no labels of a function that has fewer than 2^32 ids
      return words.subspan(2);
    default:
      return {};
  }
}

bool leads_to(Block block, Id label) {
  return std::ranges::find(targets(block.back()), label) != targets(block.back()).end();
}

void lead_elsewhere(Block& block, Id from, Id to) {
  std::ranges::replace(targets(block.back()), from, to);
}

// Of instructions that tests are made of, where the result id and the ids among operands stand. None for others.
struct Places {
  std::size_t result;  // 0: none
  std::size_t first;
  std::size_t end;
};

std::optional<Places> places_of(const Instruction& of) {
  const spv::Op op = op_of(of);
  switch (op) {
    case spv::OpLabel:
      return Places{1, 2, 2};
    case spv::OpSelectionMerge:
      return Places{0, 1, 2};
    case spv::OpBranch:
      return Places{0, 1, 2};
    case spv::OpBranchConditional:
      return Places{0, 1, 4};
    case spv::OpLoad:
      return Places{2, 3, 4};
    case spv::OpCompositeExtract:
      return Places{2, 3, 4};
    case spv::OpStore:
      return Places{0, 1, 3};
    case spv::OpFunctionCall:
    case spv::OpAccessChain:
    case spv::OpCompositeConstruct:
    case spv::OpPhi:
      return Places{2, 3, of.size()};
    case spv::OpExtInst:
      return Places{2, 5, of.size()};
    default:
      break;
  }
  const bool converts = op >= spv::OpConvertFToU && op <= spv::OpBitcast;
  const bool computes = op >= spv::OpSNegate && op <= spv::OpFUnordGreaterThanEqual;
  const bool of_bits = op >= spv::OpShiftRightLogical && op <= spv::OpBitCount;
  if (converts || computes || of_bits) return Places{2, 3, of.size()};
  return std::nullopt;
}

// A loop by the places of its blocks.
struct Loop {
  std::size_t header;
  std::size_t test_end;  // the last block of the test, which begins behind the header
  std::size_t proceeds;  // the block where a turn is done: the one that branches to the header
  std::size_t merge;
};

class Function {
 public:
  Function(Blocks blocks, Id& bound) : blocks_(std::move(blocks)), bound_(bound) {}

  Blocks rotated() && {
    for (std::size_t i = 0; i < blocks_.size(); i++) {
      if (const std::optional<Loop> loop = loop_at(i)) i = rotate(*loop);
    }
    return std::move(blocks_);
  }

 private:
  std::optional<std::size_t> place_of(Id label) const {
    const auto found = std::ranges::find(blocks_, label, label_of);
    if (found == blocks_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - blocks_.begin());
  }

  std::optional<Loop> loop_at(std::size_t header) const;
  bool is_test(std::size_t first, std::size_t last) const;
  std::size_t rotate(const Loop& loop);
  Blocks copy(std::size_t first, std::size_t last);

  Blocks blocks_;
  Id& bound_;
};

// Whether blocks lead to one another alone but for the last one, which ends with a branch, and can be copied.
bool Function::is_test(std::size_t first, std::size_t last) const {
  std::set<Id> labels;
  for (std::size_t i = first; i <= last; i++) labels.insert(label_of(blocks_[i]));
  for (std::size_t i = first; i <= last; i++) {
    if (find(blocks_[i], spv::OpLoopMerge)) return false;
    for (const Instruction& of : blocks_[i]) {
      if (!places_of(of)) return false;
    }
    Instruction branch = blocks_[i].back();
    const bool inside = std::ranges::all_of(targets(branch), [&](Id label) { return labels.contains(label); });
    if (i < last && !inside) return false;
  }
  return !find(blocks_[last], spv::OpSelectionMerge);
}

std::optional<Loop> Function::loop_at(std::size_t header) const {
  const Block& block = blocks_[header];
  const Instruction* loop = find(block, spv::OpLoopMerge);
  // A header of a compiler is nothing but a label, the loop's words and a branch to the test.
  if (!loop || block.size() != 3 || op_of(block.back()) != spv::OpBranch) return std::nullopt;
  if (((*loop)[3] & spv::LoopControlUnrollMask) != 0) return std::nullopt;
  const Id merge_label = (*loop)[1];
  const std::optional<std::size_t> merge = place_of(merge_label);
  const std::optional<std::size_t> proceeds = place_of((*loop)[2]);
  if (!merge || !proceeds || place_of(block.back()[1]) != header + 1) return std::nullopt;
  std::size_t last = header + 1;
  const auto ends = [&](const Block& of) {
    return op_of(of.back()) == spv::OpBranchConditional && leads_to(of, merge_label);
  };
  while (last < *proceeds && !ends(blocks_[last])) last++;
  if (last >= *proceeds || !is_test(header + 1, last)) return std::nullopt;
  std::size_t back = *proceeds;
  while (back < *merge && !leads_to(blocks_[back], label_of(block))) back++;
  if (back >= *merge || op_of(blocks_[back].back()) != spv::OpBranch) return std::nullopt;
  return Loop{header, last, back, *merge};
}

// With ids of its own.
Blocks Function::copy(std::size_t first, std::size_t last) {
  std::map<Id, Id> ids;
  Blocks copied(blocks_.begin() + static_cast<std::ptrdiff_t>(first),
                blocks_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  for (const Block& block : copied) {
    for (const Instruction& of : block) {
      if (const std::size_t result = places_of(of)->result) ids[of[result]] = bound_++;
    }
  }
  const auto rename = [&](std::uint32_t& id) {
    if (const auto found = ids.find(id); found != ids.end()) id = found->second;
  };
  for (Block& block : copied) {
    for (Instruction& of : block) {
      const Places places = *places_of(of);
      if (places.result != 0) rename(of[places.result]);
      for (std::size_t i = places.first; i < places.end; i++) rename(of[i]);
    }
  }
  return copied;
}

// Returns the header's place among the new blocks, which are
//   before -> guard -> header -> body -> the turn's end, test -> header, or exit -> merge
// The test stands in the guard and at the turn's end; what left the loop for `merge` leaves it for `exit`. Where the
// test has several blocks and nothing goes on early, the turn's end becomes a part of the body, with a block behind the
// test to go on by: an optimiser that joins blocks would make one of body, turn's end and header, which SPIR-V refuses
// then.
std::size_t Function::rotate(const Loop& loop) {
  const Id header = label_of(blocks_[loop.header]);
  const Id merge = label_of(blocks_[loop.merge]);
  const Id exit = bound_++;
  Instruction branch = blocks_[loop.test_end].back();
  const Id body = branch[2] == merge ? branch[3] : branch[2];

  Blocks guard = copy(loop.header + 1, loop.test_end);
  lead_elsewhere(guard.back(), body, header);
  guard.back().insert(guard.back().end() - 1, instruction(spv::OpSelectionMerge, {merge, 0}));
  Blocks test = copy(loop.header + 1, loop.test_end);
  lead_elsewhere(test.back(), body, header);
  lead_elsewhere(test.back(), merge, exit);

  for (std::size_t i = 0; i < loop.header; i++) {
    lead_elsewhere(blocks_[i], header, label_of(guard.front()));
    for (Instruction& of : blocks_[i]) {
      const bool merges = op_of(of) == spv::OpSelectionMerge || op_of(of) == spv::OpLoopMerge;
      if (merges && of[1] == header) of[1] = label_of(guard.front());
    }
  }
  for (std::size_t i = loop.test_end + 1; i < loop.merge; i++) lead_elsewhere(blocks_[i], merge, exit);
  Block& head = blocks_[loop.header];
  const Id proceeds = head[1][2];
  const auto ways = std::ranges::count_if(blocks_, [&](const Block& of) { return leads_to(of, proceeds); });
  if (test.size() > 1 && ways < 2) {
    const Id next = bound_++;
    lead_elsewhere(test.back(), header, next);
    test.push_back({instruction(spv::OpLabel, {next}), instruction(spv::OpBranch, {header})});
    head[1][2] = next;
  }
  head[1][1] = exit;
  head[2][1] = body;
  blocks_[loop.proceeds].back() = instruction(spv::OpBranch, {label_of(test.front())});

  Blocks turned;
  const auto take = [&](std::size_t first, std::size_t end) {
    std::move(blocks_.begin() + static_cast<std::ptrdiff_t>(first), blocks_.begin() + static_cast<std::ptrdiff_t>(end),
              std::back_inserter(turned));
  };
  take(0, loop.header);
  std::ranges::move(guard, std::back_inserter(turned));
  const std::size_t place = turned.size();
  take(loop.header, loop.header + 1);
  take(loop.test_end + 1, loop.proceeds + 1);
  std::ranges::move(test, std::back_inserter(turned));
  take(loop.proceeds + 1, loop.merge);
  turned.push_back({instruction(spv::OpLabel, {exit}), instruction(spv::OpBranch, {merge})});
  take(loop.merge, blocks_.size());
  blocks_ = std::move(turned);
  return place;
}

void append(std::vector<std::uint32_t>& words, const Instruction& of) {
  words.insert(words.end(), of.begin(), of.end());
}

}  // namespace

std::vector<std::uint32_t> rotate_loops(std::span<const std::uint32_t> spirv) {
  if (spirv.size() < kHeaderWords || spirv[0] != spv::MagicNumber) throw std::logic_error("this is not SPIR-V");
  std::vector<std::uint32_t> words(spirv.begin(), spirv.begin() + kHeaderWords);
  Id bound = spirv[kBound];
  Blocks blocks;  // of the function at hand
  for (std::size_t at = kHeaderWords; at < spirv.size();) {
    const std::size_t count = spirv[at] >> spv::WordCountShift;
    if (count == 0 || at + count > spirv.size()) throw std::logic_error("the SPIR-V is cut off");
    const std::span<const std::uint32_t> read = spirv.subspan(at, count);
    Instruction of(read.begin(), read.end());
    at += count;
    if (op_of(of) == spv::OpFunctionEnd) {
      for (const Block& block : Function(std::exchange(blocks, {}), bound).rotated()) {
        for (const Instruction& one : block) append(words, one);
      }
    }
    if (op_of(of) == spv::OpLabel) blocks.emplace_back();
    if (blocks.empty()) {
      append(words, of);
    } else {
      blocks.back().push_back(std::move(of));
    }
  }
  if (!blocks.empty()) throw std::logic_error("the SPIR-V is cut off");
  words[kBound] = bound;
  return words;
}

}  // namespace airlight
