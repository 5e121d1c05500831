#include <cctype>
#include <cstring>
#include <filesystem>
#include <functional>

#include "comparisons/io/array_files/array_reader.hpp"
#include "comparisons/io/array_files/interface.hpp"
#include "fem/interface/interface_stamp.hpp"  // generated
#include "lumped/problem/error.hpp"
#include "meshes/gmsh/isolated.hpp"

namespace {

using namespace rebound;

bool is_matlab(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension();
  for (char& sign : extension)
    sign = static_cast<char>(std::tolower(static_cast<unsigned char>(sign)));
  return extension == ".mat";
}

template <class Number>
void add_bytes(const Number& number, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void add_bytes(const std::string& text, std::string& bytes) {
  add_bytes(text.size(), bytes);
  bytes += text;
}

/// Takes what add_bytes() put there, in its order.
class Bytes {
 public:
  explicit Bytes(const std::string& bytes) : bytes_(bytes) {}
  bool any() const { return at_ < bytes_.size(); }
  std::size_t number() {
    std::size_t value = 0;
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::string text() {
    const std::size_t size = number();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

// The longest array takes 80 MB, several times over: on its way it is copied.
constexpr double memory_of_arrays = 4e8;  ///< [B]
// A few bytes can ask libmatio for more than there is time for.
constexpr double shortest_time = 10.0;   ///< of processor time [s]
constexpr double slowest_reading = 1e6;  ///< [B/s]; whole files take a tenth of this time

/// In a process of its own; an error that names no file gets this one.
std::string apart(const std::string& file, const std::function<std::string()>& work) {
  Isolation limits{.program = "the reader of the file"};
  std::error_code status;
  const auto size = std::filesystem::file_size(file, status);
  if (status)
    throw Error(ExitCode::input_output_failed, "cannot be read: " + status.message(),
                {.file = file});
  limits.memory = memory_of_arrays + 20.0 * static_cast<double>(size);
  limits.seconds = shortest_time + static_cast<double>(size) / slowest_reading;
  try {
    return isolated(work, limits, {});
  } catch (const Error& error) {
    ErrorLocation at = error.location();
    if (at.file.empty()) at.file = file;
    throw Error(error.code(), error.what(), at);
  }
}

class LoadedArrayFiles final : public ArrayFilesModule {
 public:
  std::vector<ArrayVariable> variables(const std::string& file) const override {
    const std::string bytes = apart(file, [&] {
      std::string all;
      for (const ArrayVariable& one :
           is_matlab(file) ? matlab_variables(file) : hdf5_variables(file)) {
        for (const std::string* text : {&one.name, &one.kind, &one.unit}) add_bytes(*text, all);
        add_bytes(one.shape.size(), all);
        for (const std::size_t length : one.shape) add_bytes(length, all);
      }
      return all;
    });
    std::vector<ArrayVariable> all;
    for (Bytes rest(bytes); rest.any();) {
      ArrayVariable& one = all.emplace_back();
      for (std::string* text : {&one.name, &one.kind, &one.unit}) *text = rest.text();
      one.shape.resize(rest.number());
      for (std::size_t& length : one.shape) length = rest.number();
    }
    return all;
  }

  std::vector<double> values(const std::string& file, const std::string& name) const override {
    const std::string bytes = apart(file, [&] {
      const auto values = is_matlab(file) ? matlab_values(file, name) : hdf5_values(file, name);
      return std::string(reinterpret_cast<const char*>(values.data()),
                         values.size() * sizeof(double));
    });
    std::vector<double> values(bytes.size() / sizeof(double));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
    return values;
  }

  void write_hdf5(const std::string& file, const std::vector<ArrayColumn>& columns,
                  const std::vector<ArrayNote>& notes) const override {
    Isolation limits{.files = Isolation::Files::writes, .program = "the writer of the file"};
    isolated(
        [&] {
          write_hdf5_columns(file, columns, notes);
          return std::string("written");
        },
        limits, {});
  }
};

}  // namespace

extern "C" const rebound::ArrayFilesModule* rebound_array_files_module(unsigned long stamp) {
  static const LoadedArrayFiles module;
  return stamp == rebound::interface_stamp ? &module : nullptr;
}
