#pragma once
// A command of ours as an application of CLI11's. Included by cli.cpp and help.cpp alone.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "app/cli/cli.h"

namespace airlight::cli {

// Parsing with it checks every value and fills the command's targets. Its ValidationError says "--option: PROBLEM".
std::unique_ptr<CLI::App> cli11_app(const Command& command);

}  // namespace airlight::cli
