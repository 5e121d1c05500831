#include "tests/support/write_arrays.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <matio.h>

#include <cstdint>
#include <map>

namespace rebound::testing {
namespace {

template <class Number>
matvar_t* variable_of(const std::string& name, const WrittenArray& array, matio_classes kind,
                      matio_types type) {
  std::vector<Number> values;
  for (const double value : array.values) values.push_back(static_cast<Number>(value));
  std::size_t shape[2] = {values.size() / array.columns, array.columns};
  return Mat_VarCreate(name.c_str(), kind, type, 2, shape, values.data(), 0);
}

matvar_t* variable_of(const std::string& name, const WrittenArray& array) {
  switch (array.type) {
    case ElementType::single_precision:
      return variable_of<float>(name, array, MAT_C_SINGLE, MAT_T_SINGLE);
    case ElementType::whole:
      return variable_of<std::int16_t>(name, array, MAT_C_INT16, MAT_T_INT16);
    default: return variable_of<double>(name, array, MAT_C_DOUBLE, MAT_T_DOUBLE);
  }
}

void write_variable(mat_t* file, matvar_t* variable) {
  ASSERT_NE(variable, nullptr);
  EXPECT_EQ(Mat_VarWrite(file, variable, MAT_COMPRESSION_ZLIB), 0);
  Mat_VarFree(variable);
}

}  // namespace

void write_matlab(const std::filesystem::path& file, const std::vector<WrittenArray>& arrays,
                  MatlabVersion version) {
  mat_t* made = Mat_CreateVer(file.c_str(), nullptr,
                              version == MatlabVersion::five ? MAT_FT_MAT5 : MAT_FT_MAT73);
  ASSERT_NE(made, nullptr) << file;
  std::map<std::string, std::vector<const WrittenArray*>> structures;
  for (const WrittenArray& array : arrays) {
    const auto dot = array.name.find('.');
    if (dot == std::string::npos)
      write_variable(made, variable_of(array.name, array));
    else
      structures[array.name.substr(0, dot)].push_back(&array);
  }
  for (const auto& [name, fields] : structures) {
    std::size_t one[2] = {1, 1};
    matvar_t* structure = Mat_VarCreateStruct(name.c_str(), 2, one, nullptr, 0);
    for (const WrittenArray* field : fields) {
      const std::string own = field->name.substr(name.size() + 1);
      Mat_VarAddStructField(structure, own.c_str());
      Mat_VarSetStructFieldByName(structure, own.c_str(), 0, variable_of(own, *field));
    }
    write_variable(made, structure);
  }
  Mat_Close(made);
}

void add_matlab_others(const std::filesystem::path& file) {
  mat_t* opened = Mat_Open(file.c_str(), MAT_ACC_RDWR);
  ASSERT_NE(opened, nullptr);
  char text[] = "half inch";
  std::size_t line[2] = {1, 9}, three[2] = {3, 1};
  write_variable(opened, Mat_VarCreate("words", MAT_C_CHAR, MAT_T_UINT8, 2, line, text, 0));
  double real[3] = {1, 2, 3}, imaginary[3] = {4, 5, 6};
  mat_complex_split_t both{real, imaginary};
  write_variable(
      opened, Mat_VarCreate("waves", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, three, &both, MAT_F_COMPLEX));
  matvar_t* cells[3];
  for (matvar_t*& cell : cells) {
    std::size_t one[2] = {1, 1};
    cell = Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, one, real, 0);
  }
  write_variable(opened, Mat_VarCreate("parts", MAT_C_CELL, MAT_T_CELL, 2, three, cells, 0));
  Mat_Close(opened);
}

void write_hdf5(const std::filesystem::path& file, const std::vector<WrittenArray>& arrays) {
  const hid_t made = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(made, 0) << file;
  const hid_t with_groups = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(with_groups, 1);
  for (const WrittenArray& array : arrays) {
    const hsize_t shape[2] = {array.values.size() / array.columns, array.columns};
    const hid_t space = H5Screate_simple(array.columns == 1 ? 1 : 2, shape, nullptr);
    const hid_t type = array.type == ElementType::single_precision ? H5T_IEEE_F32BE
                       : array.type == ElementType::whole          ? H5T_STD_I16LE
                                                                   : H5T_IEEE_F64LE;
    const hid_t data =
        H5Dcreate2(made, array.name.c_str(), type, space, with_groups, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()),
              0);
    if (!array.unit.empty()) {
      const hid_t text = H5Tcopy(H5T_C_S1);
      H5Tset_size(text, array.unit.size());
      const hid_t scalar = H5Screate(H5S_SCALAR);
      const hid_t attribute = H5Acreate2(data, "units", text, scalar, H5P_DEFAULT, H5P_DEFAULT);
      EXPECT_GE(H5Awrite(attribute, text, array.unit.data()), 0);
      H5Aclose(attribute);
      H5Sclose(scalar);
      H5Tclose(text);
    }
    H5Dclose(data);
    H5Sclose(space);
  }
  H5Pclose(with_groups);
  H5Fclose(made);
}

}  // namespace rebound::testing
