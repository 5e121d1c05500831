#include "lumped/laws/laws.hpp"

#include "lumped/problem/error.hpp"

namespace rebound {

const std::vector<LawCard>& all_laws() {
  static const std::vector<LawCard> cards = [] {
    std::vector<LawCard> list;
    for_each_law([&]<class Law>() { list.push_back(Law::card()); });
    return list;
  }();
  return cards;
}

bool has_branch(const std::string& law) {
  bool found = false;
  for_law(law, [&]<class Law>() { found = law_has_branch<Law>; });
  return found;
}

const LawCard& find_law(const std::string& name) {
  std::string names;
  for (const auto& card : all_laws()) {
    if (card.name == name) return card;
    names += (names.empty() ? "" : ", ") + card.name;
  }
  throw Error(ExitCode::bad_input, "unknown contact law '" + name + "'",
              {.key = "model.law", .value = name, .allowed = names});
}

}  // namespace rebound
