#include "comparisons/io/result_store/stored_member.hpp"

#include <algorithm>

#include "comparisons/io/results/digest.hpp"

namespace rebound {

std::string member_key(std::string_view content) {
  constexpr std::size_t digits = 32;
  return sha256(content).substr(0, digits);
}

const NamedValue* value_named(const MemberResult& member, std::string_view name) {
  const auto found = std::find_if(member.values.begin(), member.values.end(),
                                  [&](const NamedValue& one) { return one.name == name; });
  return found == member.values.end() ? nullptr : &*found;
}

}  // namespace rebound
