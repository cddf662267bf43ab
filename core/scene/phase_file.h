#pragma once
// A table of a phase function as other programs write it.

#include <filesystem>
#include <string>

#include "core/spectra/phase_table.h"

namespace airlight {

// Reads, without a look at what the numbers are:
//   CosmoScout's CSV      a heading "lambda,ANGLE,..." in degrees, rows of a wavelength in metres and values
//   AERONET's .pfn        columns "ANGLE[NNNnm]"; of several retrievals the mean
//   lines of angle,value  in degrees; "#" begins a comment
// Returns what is wrong, with the line; empty: nothing.
std::string read_phase_file(const std::filesystem::path& file, PhaseTable& table);

}  // namespace airlight
