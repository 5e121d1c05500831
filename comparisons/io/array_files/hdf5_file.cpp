#include <hdf5.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "comparisons/io/array_files/array_reader.hpp"
#include "comparisons/io/array_files/hdf5_handle.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

hid_t open(const std::string& file) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);  // a file on a read-only share can have no lock
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (opened < 0)
    throw Error(ExitCode::bad_input, "this is no HDF5 file, or it is damaged or cut off",
                {.file = file, .allowed = "an HDF5 file"});
  return opened;
}

std::string kind_of(hid_t type) {
  switch (H5Tget_class(type)) {
    case H5T_INTEGER:
    case H5T_FLOAT: return "numbers";
    case H5T_STRING: return "text";
    case H5T_COMPOUND: return "records of several fields";
    default: return "values that are no numbers";
  }
}

std::vector<std::size_t> shape_of(hid_t data) {
  const Hdf5Handle space(H5Dget_space(data), H5Sclose);
  const int rank = space.is_open() ? H5Sget_simple_extent_ndims(space.id()) : -1;
  if (rank <= 0) return {};
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  return {shape.begin(), shape.end()};
}

/// The text of an attribute; empty where there is none.
std::string text_of(hid_t data, const char* name) {
  if (H5Aexists(data, name) <= 0) return {};
  const Hdf5Handle attribute(H5Aopen(data, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (!type.is_open() || H5Tget_class(type.id()) != H5T_STRING ||
      H5Sget_simple_extent_npoints(space.id()) != 1)
    return {};
  if (H5Tis_variable_str(type.id()) > 0) {
    char* text = nullptr;
    const Hdf5Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(memory.id(), H5T_VARIABLE);
    H5Tset_cset(memory.id(), H5Tget_cset(type.id()));
    if (H5Aread(attribute.id(), memory.id(), static_cast<void*>(&text)) < 0 || !text) return {};
    std::string all = text;
    H5free_memory(text);
    return all;
  }
  constexpr std::size_t longest_unit = 200;
  const std::size_t size = H5Tget_size(type.id());
  std::string all(std::min(size, longest_unit + 1), '\0');
  if (size > longest_unit || H5Aread(attribute.id(), type.id(), all.data()) < 0) return {};
  all.resize(std::min(all.find('\0'), all.size()));
  while (!all.empty() && all.back() == ' ') all.pop_back();  // padded as Fortran does
  return all;
}

herr_t look_at(hid_t file, const char* name, const H5O_info_t* about, void* list) {
  auto& all = *static_cast<std::vector<ArrayVariable>*>(list);
  if (about->type != H5O_TYPE_DATASET) return 0;
  if (all.size() > most_variables) return 1;  // enough to be refused
  const Hdf5Handle data(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  if (!data.is_open()) return 0;
  const Hdf5Handle type(H5Dget_type(data.id()), H5Tclose);
  ArrayVariable one{.name = name,
                    .shape = shape_of(data.id()),
                    .kind = kind_of(type.id()),
                    .unit = text_of(data.id(), "units")};
  if (one.unit.empty()) one.unit = text_of(data.id(), "unit");
  all.push_back(std::move(one));
  return 0;
}

}  // namespace

std::vector<ArrayVariable> hdf5_variables(const std::string& file) {
  const Hdf5Handle opened(open(file), H5Fclose);
  std::vector<ArrayVariable> all;
  if (H5Ovisit2(opened.id(), H5_INDEX_NAME, H5_ITER_INC, look_at, &all, H5O_INFO_BASIC) < 0)
    throw Error(ExitCode::bad_input, "the contents cannot be listed: is the file damaged?",
                {.file = file});
  if (all.size() > most_variables)
    throw Error(ExitCode::bad_input, "the file has more than 4096 data sets", {.file = file});
  return all;
}

std::vector<double> hdf5_values(const std::string& file, const std::string& name) {
  const Hdf5Handle opened(open(file), H5Fclose);
  const Hdf5Handle data(H5Dopen2(opened.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const auto refuse = [&](const char* reason) {
    throw Error(ExitCode::bad_input, reason, {.file = file, .key = name});
  };
  if (!data.is_open()) refuse("the data set cannot be read: is the file damaged?");
  std::size_t count = 1;
  for (const std::size_t length : shape_of(data.id())) {
    if (length > longest_array || count * length > longest_array)
      refuse("the data set has more than 10000000 numbers");
    count *= length;
  }
  const Hdf5Handle type(H5Dget_type(data.id()), H5Tclose);
  if (kind_of(type.id()) != "numbers") refuse("the data set holds no numbers");
  std::vector<double> values(count);
  if (H5Dread(data.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    refuse("the numbers of the data set cannot be read: is the file damaged or cut off?");
  return values;
}

}  // namespace rebound
