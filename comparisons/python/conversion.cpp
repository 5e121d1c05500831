#include <toml++/toml.h>

#include <cmath>
#include <sstream>

#include "comparisons/python/binding.hpp"

namespace rebound::python {
namespace {

[[noreturn]] void refuse(const std::string& key, const py::handle& value) {
  throw Error(ExitCode::bad_input, "a value of this type has no place in an input",
              {.key = key,
               .value = py::str(value),
               .allowed = "numbers, texts, truth values, lists and dicts"});
}

std::string element_path(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

toml::table table_of(const py::dict& dict, const std::string& path);
toml::array array_of(const py::handle& sequence, const std::string& path);

/// Hands `put` the value of TOML that stands for a value of Python.
template <class Put>
void convert(const py::handle& value, const std::string& path, const Put& put) {
  if (py::isinstance<py::bool_>(value)) return put(value.cast<bool>());
  if (py::isinstance<py::str>(value)) return put(value.cast<std::string>());
  if (py::isinstance<py::dict>(value))
    return put(table_of(py::reinterpret_borrow<py::dict>(value), path));
  if (PyFloat_Check(value.ptr())) return put(value.cast<double>());
  if (PyIndex_Check(value.ptr())) return put(value.cast<std::int64_t>());
  if (PySequence_Check(value.ptr())) return put(array_of(value, path));
  if (PyNumber_Check(value.ptr())) return put(py::float_(value.cast<py::object>()).cast<double>());
  refuse(path, value);
}

toml::array array_of(const py::handle& sequence, const std::string& path) {
  toml::array array;
  for (const py::handle element : sequence)
    convert(element, element_path(path, array.size()),
            [&](auto&& one) { array.push_back(std::forward<decltype(one)>(one)); });
  return array;
}

toml::table table_of(const py::dict& dict, const std::string& path) {
  toml::table table;
  for (const auto& [name, value] : dict) {
    if (value.is_none()) continue;  // as an argument that is not given
    const auto key = name.cast<std::string>();
    std::string place = path.empty() ? std::string() : path + ".";
    place += key;
    convert(value, place,
            [&](auto&& one) { table.insert_or_assign(key, std::forward<decltype(one)>(one)); });
  }
  return table;
}

}  // namespace

py::object to_python(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: {
      py::dict dict;
      for (const auto& [key, value] : json.items()) dict[py::str(key)] = to_python(value);
      return dict;
    }
    case Json::value_t::array: {
      py::list list;
      for (const Json& value : json) list.append(to_python(value));
      return list;
    }
    case Json::value_t::string:
      return py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
          json.get_ref<const std::string&>().data(),
          static_cast<Py_ssize_t>(json.get_ref<const std::string&>().size()), "replace"));
    case Json::value_t::boolean: return py::bool_(json.get<bool>());
    case Json::value_t::number_integer: return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned: return py::int_(json.get<std::uint64_t>());
    case Json::value_t::number_float:
      if (std::isfinite(json.get<double>())) return py::float_(json.get<double>());
      return py::none();
    default: return py::none();
  }
}

Document document_of(const Source& source, const std::string& tier) {
  const int given = static_cast<int>(!source.file.is_none()) +
                    static_cast<int>(!source.text.is_none()) +
                    static_cast<int>(!source.tables.empty());
  if (given != 1)
    throw Error(ExitCode::bad_input,
                "give one of a file, its text (text=...), and its tables as keyword arguments");
  if (!source.file.is_none())
    return Document::load(
        py::str(py::module_::import("os").attr("fspath")(source.file)).cast<std::string>());
  if (!source.text.is_none()) return Document::parse(source.text.cast<std::string>(), "text");
  toml::table table = table_of(source.tables, "");
  if (!table.contains("schema")) table.insert("schema", 1);
  if (toml::table* model = table["model"].as_table(); model && !tier.empty())
    model->insert("tier", tier);  // unless it says so itself
  std::ostringstream text;
  text << table;
  return Document::parse(text.str(), keywords_name, PlainNumbers::are_si);
}

py::array view(const std::vector<double>& values, const py::handle& owner) {
  py::array_t<double> array(static_cast<py::ssize_t>(values.size()), values.data(), owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::array rows(std::vector<double> values, std::size_t length) {
  auto owned = std::make_unique<std::vector<double>>(std::move(values));
  const std::vector<double>& numbers = *owned;
  const py::capsule owner(owned.release(),
                          [](void* held) { delete static_cast<std::vector<double>*>(held); });
  return py::array_t<double>({length == 0 ? 0 : numbers.size() / length, length}, numbers.data(),
                             owner);
}

}  // namespace rebound::python
