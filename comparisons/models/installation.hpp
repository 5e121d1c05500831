#pragma once

#include <filesystem>
#include <string>

/// Where the files that belong to the program lie. It runs from the tree it was
/// built in, from wherever `cmake --install` put it, and inside other programs
/// that use its libraries, or load one that holds them, as Python does: then the
/// folder of that library, and those above it, take the place of the program's own.
namespace rebound {

/// The library of a module that is loaded on first use: the first that exists
/// of PROGRAM_FOLDER, PROGRAM_FOLDER/../lib/rebound (and of folders above it), and the
/// folder this library was to be installed to; the first of these where none exists.
/// Errors: Error(input_output_failed) when the program's own folder cannot be found.
std::filesystem::path module_file(const std::string& name);

/// Data sets and published constants: PROGRAM_FOLDER/../share/rebound/data where
/// that exists, else those of the sources.
std::filesystem::path data_folder();

/// Seeded faults and their recorded outcomes, found as data_folder() is.
std::filesystem::path seeded_faults_folder();

/// The stored campaign of error bars, found as data_folder() is.
std::filesystem::path coverage_file();

/// The sources this library was built from; empty where they are no longer there.
std::filesystem::path source_folder();

}  // namespace rebound
