#include <matio.h>

#include <cstdint>
#include <memory>
#include <utility>

#include "comparisons/io/array_files/array_reader.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using File = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using Variable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

constexpr int deepest_structure = 4;

File open(const std::string& file) {
  File opened(Mat_Open(file.c_str(), MAT_ACC_RDONLY), Mat_Close);
  if (!opened)
    throw Error(ExitCode::bad_input, "this is no MATLAB file, or its beginning is damaged",
                {.file = file, .allowed = "a .mat file of version 4, 5 or 7.3"});
  return opened;
}

std::string kind_of(const matvar_t& variable) {
  if (variable.isComplex) return "complex numbers";
  if (variable.isLogical) return "logical values";
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
    case MAT_C_SINGLE:
    case MAT_C_INT8:
    case MAT_C_UINT8:
    case MAT_C_INT16:
    case MAT_C_UINT16:
    case MAT_C_INT32:
    case MAT_C_UINT32:
    case MAT_C_INT64:
    case MAT_C_UINT64: return "numbers";
    case MAT_C_CHAR: return "text";
    case MAT_C_CELL: return "a cell array";
    case MAT_C_STRUCT: return "an array of structures";
    case MAT_C_SPARSE: return "a sparse matrix";
    default: return "an object";
  }
}

bool is_one_structure(const matvar_t& variable) {
  if (variable.class_type != MAT_C_STRUCT) return false;
  for (int i = 0; i < variable.rank; ++i)
    if (variable.dims[i] != 1) return false;
  return true;
}

/// The variable, or, of one structure, its fields.
template <class Look>
void look_at(const matvar_t& variable, const std::string& name, int depth, const Look& look) {
  if (!is_one_structure(variable) || depth == deepest_structure) {
    look(variable, name);
    return;
  }
  // The library takes no pointers to constants.
  auto* structure = const_cast<matvar_t*>(&variable);
  const char* const* fields = Mat_VarGetStructFieldnames(structure);
  const unsigned count = Mat_VarGetNumberOfFields(structure);
  for (unsigned i = 0; fields && i < count; ++i) {
    const matvar_t* field = Mat_VarGetStructFieldByIndex(structure, i, 0);
    if (field && fields[i]) look_at(*field, name + "." + fields[i], depth + 1, look);
  }
}

template <class Number>
std::vector<double> numbers_as(const matvar_t& variable, std::size_t count) {
  const auto* first = static_cast<const Number*>(variable.data);
  return {first, first + count};
}

std::vector<double> numbers_of(const matvar_t& variable, std::size_t count) {
  switch (variable.data_type) {
    case MAT_T_DOUBLE: return numbers_as<double>(variable, count);
    case MAT_T_SINGLE: return numbers_as<float>(variable, count);
    case MAT_T_INT8: return numbers_as<std::int8_t>(variable, count);
    case MAT_T_UINT8: return numbers_as<std::uint8_t>(variable, count);
    case MAT_T_INT16: return numbers_as<std::int16_t>(variable, count);
    case MAT_T_UINT16: return numbers_as<std::uint16_t>(variable, count);
    case MAT_T_INT32: return numbers_as<std::int32_t>(variable, count);
    case MAT_T_UINT32: return numbers_as<std::uint32_t>(variable, count);
    case MAT_T_INT64: return numbers_as<std::int64_t>(variable, count);
    case MAT_T_UINT64: return numbers_as<std::uint64_t>(variable, count);
    default: return {};
  }
}

std::size_t count_of(const matvar_t& variable) {
  std::size_t count = 1;
  for (int i = 0; i < variable.rank; ++i) {
    if (variable.dims[i] > longest_array) return longest_array + 1;
    count *= variable.dims[i];
    if (count > longest_array) return longest_array + 1;
  }
  return count;
}

}  // namespace

std::vector<ArrayVariable> matlab_variables(const std::string& file) {
  const File opened = open(file);
  std::vector<ArrayVariable> all;
  while (const Variable variable{Mat_VarReadNextInfo(opened.get()), Mat_VarFree}) {
    if (!variable->name) continue;
    look_at(*variable, variable->name, 0, [&](const matvar_t& one, const std::string& name) {
      if (all.size() == most_variables)
        throw Error(ExitCode::bad_input, "the file has more than 4096 variables", {.file = file});
      all.push_back({.name = name,
                     .shape = {one.dims, one.dims + one.rank},
                     .kind = kind_of(one),
                     .unit = {}});
    });
  }
  return all;
}

std::vector<double> matlab_values(const std::string& file, const std::string& name) {
  const File opened = open(file);
  const std::string top = name.substr(0, name.find('.'));
  const Variable variable(Mat_VarRead(opened.get(), top.c_str()), Mat_VarFree);
  std::vector<double> values;
  bool found = false;
  if (variable)
    look_at(*variable, top, 0, [&](const matvar_t& one, const std::string& path) {
      if (path != name) return;
      found = true;
      const std::size_t count = count_of(one);
      if (kind_of(one) != "numbers" || count > longest_array) return;
      const bool whole = one.data && one.data_size > 0 &&
                         one.nbytes >= count * static_cast<std::size_t>(one.data_size);
      if (whole) values = numbers_of(one, count);
    });
  if (!found || values.empty())
    throw Error(ExitCode::bad_input,
                found ? "the numbers of the variable cannot be read: damaged, or too many?"
                      : "the variable cannot be read: is the file damaged or cut off?",
                {.file = file, .key = name});
  return values;
}

}  // namespace rebound
