#pragma once

#include <string>
#include <vector>

#include "comparisons/io/array_files/interface.hpp"

/// What the module does in a process of its own, by file kind.
namespace rebound {

/// The most variables of a file, and numbers of one.
inline constexpr std::size_t most_variables = 4096;
inline constexpr std::size_t longest_array = 10'000'000;

/// Errors: Error(bad_input) for a file that is none or is damaged, has too many variables.
std::vector<ArrayVariable> matlab_variables(const std::string& file);
std::vector<ArrayVariable> hdf5_variables(const std::string& file);

/// Errors: Error(bad_input) also where there is no such variable, it is no numbers or too long.
std::vector<double> matlab_values(const std::string& file, const std::string& name);
std::vector<double> hdf5_values(const std::string& file, const std::string& name);

/// Errors: Error(input_output_failed).
void write_hdf5_columns(const std::string& file, const std::vector<ArrayColumn>& columns,
                        const std::vector<ArrayNote>& notes);

}  // namespace rebound
