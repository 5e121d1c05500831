#pragma once

#include <array>
#include <string>
#include <vector>

/// Names of an enum's values, said once and beside the enum, in files, help, schema,
/// results and reports alike:
///
///   enum class Relaxes { all, deviator };
///   constexpr auto names_of(Relaxes) {
///     return names_list<Relaxes>({{"all", Relaxes::all}, {"deviator", Relaxes::deviator}});
///   }
namespace rebound {

template <class Enum>
struct Named {
  const char* name;
  Enum value;
};

template <class Enum, std::size_t count>
constexpr std::array<Named<Enum>, count> names_list(const Named<Enum> (&list)[count]) {
  return std::to_array(list);
}

/// An enum with such a list.
template <class Enum>
concept NamedEnum = requires(Enum value) {
  names_of(value).front().name;
};

template <NamedEnum Enum>
constexpr const char* name_of(Enum value) {
  for (const auto& [name, known] : names_of(value))
    if (known == value) return name;
  return "";
}

/// Sets `value` to what `text` names; false, and nothing is set, where there is no such name.
template <NamedEnum Enum>
bool read_name(const std::string& text, Enum& value) {
  for (const auto& [name, known] : names_of(value))
    if (text == name) {
      value = known;
      return true;
    }
  return false;
}

/// All names, in the order of the list.
template <NamedEnum Enum>
std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& [name, value] : names_of(Enum{})) names.emplace_back(name);
  return names;
}

}  // namespace rebound
