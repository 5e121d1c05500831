#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// MATLAB and HDF5 files as laboratories have them, written by the libraries themselves.
namespace rebound::testing {

enum class MatlabVersion { five, seven_three };
enum class ElementType { double_precision, single_precision, whole };

struct WrittenArray {
  std::string name;
  std::vector<double> values;
  std::string unit{};       ///< of an attribute "units"; HDF5 alone
  std::size_t columns = 1;  ///< of a matrix, values one column after the other
  ElementType type = ElementType::double_precision;
};

/// A dot in a name is a structure: "run.force".
void write_matlab(const std::filesystem::path& file, const std::vector<WrittenArray>& arrays,
                  MatlabVersion version = MatlabVersion::five);

/// Adds what is no array of real numbers: "words" (text), "waves" (complex), "parts" (cells).
void add_matlab_others(const std::filesystem::path& file);

/// A slash in a name is a group.
void write_hdf5(const std::filesystem::path& file, const std::vector<WrittenArray>& arrays);

}  // namespace rebound::testing
