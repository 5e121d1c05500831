#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The narrow interface of the module "rebound_array_files", loaded on first use, so that the
/// program itself links neither HDF5 nor what that brings.
namespace rebound {

/// A variable of a file that holds arrays.
struct ArrayVariable {
  std::string name;  ///< of a field "structure.field", of a data set in a group "group/name"
  std::vector<std::size_t> shape;
  std::string kind;  ///< "numbers", or what it is instead: "text", "complex numbers"
  std::string unit;  ///< of an attribute "units" or "unit"; empty: none

  bool is_numbers() const { return kind == "numbers"; }
};

/// A column to be written, of numbers or of texts.
struct ArrayColumn {
  std::string name;
  std::vector<double> numbers{};
  std::vector<std::string> texts{};
};

/// A text about a whole file.
struct ArrayNote {
  std::string name, text;
};

/// Reads MATLAB files (.mat of versions 4, 5 and 7.3, by libmatio) and HDF5 files; writes these.
///
/// Each call works in a process of its own that ends with it: crashes of the libraries on damaged
/// files stay there. Errors: Error(bad_input) with the file for one that is of another kind or is
/// damaged; Error(input_output_failed) where it cannot be read.
class ArrayFilesModule {
 public:
  virtual ~ArrayFilesModule() = default;

  virtual std::vector<ArrayVariable> variables(const std::string& file) const = 0;

  /// Numbers of any real type, in the order of the file. Errors: also Error(bad_input) where there
  /// is no variable of that name, or it holds no numbers.
  virtual std::vector<double> values(const std::string& file, const std::string& name) const = 0;

  /// Writes one data set a column, compressed, and one a note in the group "about".
  /// Errors: Error(input_output_failed); what was begun is left there.
  virtual void write_hdf5(const std::string& file, const std::vector<ArrayColumn>& columns,
                          const std::vector<ArrayNote>& notes) const = 0;
};

/// An `extern "C"` function as gmsh_entry_point is one.
inline constexpr const char* array_files_entry_point = "rebound_array_files_module";

}  // namespace rebound
