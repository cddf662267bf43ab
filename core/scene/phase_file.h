#pragma once
// A table of a phase function in the format of another program.

#include <filesystem>
#include <string>

#include "core/spectra/phase_table.h"

namespace airlight {

// Reads a file of one of these formats, without judging the numbers:
//   CosmoScout's CSV      a heading "lambda,ANGLE,..." in degrees, rows of a wavelength in metres and values
//   AERONET's .pfn        columns "ANGLE[NNNnm]"; of several retrievals the mean
//   lines of angle,value  in degrees; "#" begins a comment
// Returns the error, with its line; empty: none.
std::string read_phase_file(const std::filesystem::path& file, PhaseTable& table);

}  // namespace airlight
