#include <hdf5.h>

#include <algorithm>

#include "comparisons/io/array_files/array_reader.hpp"
#include "comparisons/io/array_files/hdf5_handle.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

class Writer {
 public:
  explicit Writer(const std::string& file)
      : name_(file),
        file_(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose) {
    need(file_.is_open());
  }

  void write(const ArrayColumn& column) const {
    const std::size_t rows = std::max(column.numbers.size(), column.texts.size());
    const hsize_t shape[1] = {rows};
    const Hdf5Handle space(H5Screate_simple(1, shape, nullptr), H5Sclose);
    const Hdf5Handle storage(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    if (rows > 0) {
      constexpr hsize_t longest_chunk = 16384;
      constexpr unsigned quickest = 1;
      const hsize_t chunk[1] = {std::min<hsize_t>(rows, longest_chunk)};
      H5Pset_chunk(storage.id(), 1, chunk);
      H5Pset_shuffle(storage.id());
      H5Pset_deflate(storage.id(), quickest);
    }
    if (column.texts.empty()) {
      write(column.name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space, storage, column.numbers.data());
      return;
    }
    std::size_t longest = 1;
    for (const std::string& text : column.texts) longest = std::max(longest, text.size());
    std::string all(longest * rows, '\0');
    for (std::size_t i = 0; i < rows; ++i)
      std::copy(column.texts[i].begin(), column.texts[i].end(),
                all.begin() + static_cast<std::ptrdiff_t>(i * longest));
    const Hdf5Handle type(text_type(longest), H5Tclose);
    write(column.name, type.id(), type.id(), space, storage, all.data());
  }

  /// A text that belongs to the whole file; longer than an attribute may be.
  void note(const ArrayNote& note) const {
    const Hdf5Handle type(text_type(note.text.size() + 1), H5Tclose);
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle storage(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    write("about/" + note.name, type.id(), type.id(), space, storage, note.text.c_str());
  }

  void flush() const { need(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0); }

 private:
  static hid_t text_type(std::size_t size) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, size);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
  }

  void write(const std::string& name, hid_t stored, hid_t given, const Hdf5Handle& space,
             const Hdf5Handle& storage, const void* values) const {
    const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links.id(), 1);
    const Hdf5Handle data(H5Dcreate2(file_.id(), name.c_str(), stored, space.id(), links.id(),
                                     storage.id(), H5P_DEFAULT),
                          H5Dclose);
    need(data.is_open() && H5Dwrite(data.id(), given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
  }

  void need(bool done) const {
    if (!done)
      throw Error(ExitCode::input_output_failed, "the HDF5 file cannot be written",
                  {.file = name_});
  }

  std::string name_;
  Hdf5Handle file_;
};

}  // namespace

void write_hdf5_columns(const std::string& file, const std::vector<ArrayColumn>& columns,
                        const std::vector<ArrayNote>& notes) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Writer writer(file);
  for (const ArrayNote& note : notes) writer.note(note);
  for (const ArrayColumn& column : columns) writer.write(column);
  writer.flush();
}

}  // namespace rebound
