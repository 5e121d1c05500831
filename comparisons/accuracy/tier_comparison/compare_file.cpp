#include "comparisons/accuracy/tier_comparison/compare_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/units.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

bool is_file_name(const std::string& name) {
  return !name.empty() && name.size() < 100 &&
         std::all_of(name.begin(), name.end(), [](unsigned char sign) {
           return std::isalnum(sign) || sign == '-' || sign == '_';
         });
}

void check_speeds(const Document& document, const CompareCase& one, const std::string& key) {
  for (const std::string& speed : one.speeds) {
    try {
      if (parse_quantity(speed, dimension::speed) > 0.0) continue;
    } catch (const Error& error) {
      throw document.error_at(key + ".speeds", error.what(), "speeds like \"15 m/s\"");
    }
    throw document.error_at(key + ".speeds", "a speed must be positive", "value > 0 m/s");
  }
}

}  // namespace

const std::vector<std::string>& compared_keys() {
  static const std::vector<std::string> keys{"restitution",         "contact_time_s",
                                             "contact_time_1pct_s", "peak_force_N",
                                             "peak_deflection_m",   "mean_deflection_m"};
  return keys;
}

void describe(Visitor& visit, CompareCase& one) {
  visit.text({.name = "name", .sentence = "Names the case and its baseline file."}, one.name);
  visit.text({.name = "lumped",
              .sentence = "Impact file of the lumped tier, relative to this file.",
              .presence = Presence::optional},
             one.lumped);
  visit.text({.name = "fem",
              .sentence = "Impact file of the FE tier, relative to this file.",
              .presence = Presence::optional},
             one.fem);
  visit.texts({.name = "speeds",
               .sentence = "Speeds, e.g. [\"5 m/s\", \"15 m/s\"]; default: that of the files.",
               .presence = Presence::optional},
              one.speeds);
  visit.visit_table({.name = "agreement",
                     .sentence = "How far the tiers may differ beyond their numerical errors, as a "
                                 "share of FE; without it a gap is told and not judged.",
                     .presence = Presence::optional},
                    [&](Visitor& inner) {
                      for (const std::string& key : compared_keys()) {
                        std::optional<double> share;
                        if (const auto known = one.agreement.find(key);
                            known != one.agreement.end())
                          share = known->second;
                        inner.number({.name = key,
                                      .sentence = "Largest share of that scalar.",
                                      .presence = Presence::optional,
                                      .range = from_to(0.0, 10.0)},
                                     share);
                        if (share) one.agreement[key] = *share;
                      }
                    });
}

void describe(Visitor& visit, CompareFile& file) {
  describe_schema(visit);
  visit.list({.name = "case", .sentence = "An impact in one tier or both; repeat for more."},
             file.cases);
}

CompareFile read_compare_file(const Document& document) {
  CompareFile file;
  read_document(document, file);
  std::set<std::string> names;
  for (std::size_t i = 0; i < file.cases.size(); ++i) {
    const CompareCase& one = file.cases[i];
    const std::string key = fmt::format("case[{}]", i);
    if (!is_file_name(one.name))
      throw document.error_at(key + ".name", "the name becomes the name of a file",
                              "letters, digits, - and _");
    if (!names.insert(one.name).second)
      throw document.error_at(key + ".name", "two cases have this name");
    if (one.lumped.empty() && one.fem.empty())
      throw document.error_at(key, "the case has no tier: lumped, fem or both are needed");
    if (!one.agreement.empty() && (one.lumped.empty() || one.fem.empty()))
      throw document.error_at(key + ".agreement", "one tier agrees with itself");
    check_speeds(document, one, key);
  }
  if (file.cases.empty()) throw document.error_at("case", "there is no case");
  return file;
}

}  // namespace rebound
