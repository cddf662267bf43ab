#pragma once
// Makes loops that test after each turn of those of a SPIR-V module that test before it [loop rotation, as compilers
// call it]:
//
//   loop { if (!goes_on) break; body }   ->   if (goes_on) loop { body; if (!goes_on) break; }
//
// A device without branches of its own, which runs lanes side by side under a mask, leaves a loop where a turn ends, if
// then no lane is left. What stands behind a test at the turn's start is therefore run once more for lanes that are all
// masked: a loop of n turns costs n + 1, and nested ones multiply. A loop that tests at its end costs n, or 1 where n
// is 0. core/METHODS.md has what it gains.

#include <cstdint>
#include <span>
#include <vector>

namespace airlight {

// Takes a module for Vulkan as a compiler writes it: values that live on from block to block stand in variables. Loops
// that are to be unrolled are left alone, since the unroller looks for tests at their start; so are loops whose test
// holds another loop or leaves on several ways. Throws std::logic_error on words that are not SPIR-V.
std::vector<std::uint32_t> rotate_loops(std::span<const std::uint32_t> spirv);

}  // namespace airlight
