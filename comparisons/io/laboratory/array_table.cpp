#include "comparisons/io/laboratory/array_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <set>

#include "comparisons/io/laboratory/table_headings.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/models/installation.hpp"
#include "fem/interface/interface_stamp.hpp"  // generated
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

#ifdef REBOUND_HAS_ARRAY_FILES
constexpr bool built_with_array_files = true;
#else
constexpr bool built_with_array_files = false;
#endif

const ArrayFilesModule& array_files(const std::filesystem::path& file) {
  if (!built_with_array_files)
    throw Error(ExitCode::bad_input,
                "this program was built without the libraries that read MATLAB and HDF5 files "
                "(Debian: libmatio-dev, libhdf5-dev); install them and build again",
                {.file = file.string(), .allowed = "a table as text"});
  static const auto& module = *static_cast<const ArrayFilesModule*>(open_module(
      {.file = module_file("rebound_array_files").string(), .entry_point = array_files_entry_point},
      interface_stamp));
  return module;
}

/// The last part of "group/force_kN" may hold a unit.
ColumnHeading heading_of(const ArrayVariable& variable) {
  const auto slash = variable.name.rfind('/');
  const std::string above =
      slash == std::string::npos ? std::string() : variable.name.substr(0, slash + 1);
  const ColumnHeading last = parse_heading(variable.name.substr(above.size()));
  return {.text = variable.name,
          .name = above + last.name,
          .unit = variable.unit.empty() ? last.unit : variable.unit};
}

std::size_t count_of(const ArrayVariable& variable) {
  return std::accumulate(variable.shape.begin(), variable.shape.end(), std::size_t{1},
                         std::multiplies<>());
}

/// N, N x 1 or 1 x N.
bool is_vector(const ArrayVariable& variable) {
  return std::count_if(variable.shape.begin(), variable.shape.end(),
                       [](std::size_t length) { return length != 1; }) <= 1;
}

std::string shape_text(const ArrayVariable& variable) {
  std::string text;
  for (const std::size_t length : variable.shape)
    text += fmt::format("{}{}", text.empty() ? "" : " x ", length);
  return text.empty() ? "1" : text;
}

std::string listed(const std::vector<ArrayVariable>& variables) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, variables.size()); ++i)
    text += (i == 0 ? "" : " | ") + variables[i].name;
  return variables.size() > most ? text + " | ..." : text;
}

class ArrayTableReader {
 public:
  ArrayTableReader(const std::filesystem::path& file, const std::vector<WantedColumn>& wanted)
      : file_(file.string()), wanted_(wanted), variables_(array_files(file).variables(file_)) {}

  LaboratoryTable read() {
    for (const WantedColumn& column : wanted_) read_column(column);
    table_.lines.resize(rows_);
    std::iota(table_.lines.begin(), table_.lines.end(), 1);
    return std::move(table_);
  }

 private:
  void read_column(const WantedColumn& wanted) {
    ReadColumn& column = table_.columns.emplace_back();
    const ArrayVariable* found = find(wanted.heading);
    if (!found && wanted.is_optional) return;
    if (!found)
      refuse("the variable is missing", wanted.heading, listed(variables_),
             "a variable of the file");
    column.heading = heading_of(*found);
    const std::string& name = found->name;
    if (wanted.accepted.empty())
      refuse("text is not read from MATLAB and HDF5 files", name, found->kind, "a text file");
    if (!found->is_numbers())
      refuse("the variable holds no real numbers", name, found->kind, "a vector of real numbers");
    if (!is_vector(*found))
      refuse("the variable is no vector", name, shape_text(*found), "N, N x 1 or 1 x N numbers");
    const std::size_t count = count_of(*found);
    if (count == 0) refuse("the variable is empty", name, shape_text(*found), "N numbers");
    if (rows_ != 0 && count != rows_)
      refuse("the variable is not as long as the one before", name, fmt::format("{}", count),
             fmt::format("{} numbers, as {} has", rows_, first_));
    rows_ = count;
    if (first_.empty()) first_ = name;
    if (column.heading.unit.empty()) column.heading.unit = wanted.unit;
    const double factor = accepted_factor(file_, wanted, column, 0);
    column.numbers = array_files(file_).values(file_, name);
    check(wanted, name, column.numbers);
    for (double& number : column.numbers) number *= factor;
  }

  /// As written first, then by the name without its unit.
  const ArrayVariable* find(const std::string& wanted) const {
    const ArrayVariable* found = nullptr;
    for (const ArrayVariable& one : variables_)
      if (one.name == wanted) return &one;
    for (const ArrayVariable& one : variables_) {
      if (heading_of(one).name != wanted) continue;
      if (found)
        refuse("two variables have this name", wanted, found->name + " | " + one.name,
               "the whole name of one");
      found = &one;
    }
    return found;
  }

  void check(const WantedColumn& wanted, const std::string& name,
             const std::vector<double>& numbers) const {
    if (numbers.size() != rows_)
      refuse("the variable is cut off", name, fmt::format("{}", numbers.size()),
             fmt::format("{} numbers", rows_));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!std::isfinite(numbers[i]))
        refuse(fmt::format("element {} is not finite", i + 1), name, fmt::format("{}", numbers[i]),
               "finite numbers");
      if (wanted.increases && i > 0 && !(numbers[i] > numbers[i - 1]))
        refuse(fmt::format("element {} does not increase", i + 1), name,
               fmt::format("{:.9g}", numbers[i]),
               fmt::format("a value above that before it, {:.9g}", numbers[i - 1]));
    }
  }

  [[noreturn]] void refuse(const std::string& reason, const std::string& key,
                           const std::string& value, const std::string& allowed) const {
    throw Error(ExitCode::bad_input, reason,
                {.file = file_, .key = key, .value = value, .allowed = allowed});
  }

  std::string file_;
  const std::vector<WantedColumn>& wanted_;
  std::vector<ArrayVariable> variables_;
  LaboratoryTable table_;
  std::size_t rows_ = 0;
  std::string first_;  ///< the variable that says how many rows there are
};

}  // namespace

bool is_array_file(const std::filesystem::path& file) {
  std::string extension = file.extension();
  for (char& sign : extension)
    sign = static_cast<char>(std::tolower(static_cast<unsigned char>(sign)));
  return std::set<std::string>{".mat", ".h5", ".hdf5", ".hdf"}.contains(extension);
}

LaboratoryTable read_array_table(const std::filesystem::path& file,
                                 const std::vector<WantedColumn>& wanted) {
  return ArrayTableReader(file, wanted).read();
}

TablePreview preview_array_file(const std::filesystem::path& file) {
  const auto variables = array_files(file).variables(file.string());
  TablePreview preview;
  for (const ArrayVariable& one : variables)
    if (one.is_numbers() && is_vector(one)) preview.rows = std::max(preview.rows, count_of(one));
  if (preview.rows == 0)
    throw Error(ExitCode::bad_input, "the file holds no vector of real numbers",
                {.file = file.string(), .value = listed(variables)});
  for (const ArrayVariable& one : variables) {
    preview.headings.push_back(heading_of(one));
    preview.is_number.push_back(one.is_numbers() && is_vector(one) &&
                                count_of(one) == preview.rows);
    preview.columns_at.push_back(0);
  }
  return preview;
}

void write_array_table(const std::filesystem::path& file, const std::vector<ArrayColumn>& columns,
                       const std::vector<ArrayNote>& notes) {
  const std::filesystem::path part = file.string() + ".part";
  std::error_code status;
  try {
    array_files(file).write_hdf5(part.string(), columns, notes);
  } catch (const Error& error) {
    std::filesystem::remove(part, status);
    throw Error(error.code(), error.what(), {.file = file.string()});
  }
  std::filesystem::rename(part, file, status);
  if (status)
    throw Error(ExitCode::input_output_failed, "cannot be written: " + status.message(),
                {.file = file.string()});
}

}  // namespace rebound
