#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "comparisons/io/results/digest.hpp"
#include "comparisons/studies/campaign/campaign.hpp"
#include "comparisons/studies/campaign/each_number.hpp"

namespace rebound {

/// The file that a campaign varies: which numbers it has, and what a member with others does.
struct Campaign::Base {
  explicit Base(Document read) : document(std::move(read)) {}
  virtual ~Base() = default;

  /// Every number that the file could give, by its key path.
  virtual std::vector<Key> numbers() const = 0;
  /// Does the file itself give the number at a path?
  virtual bool gives(const std::string& path) const;
  virtual bool of_impacts() const { return false; }
  /// May be called from several threads at once.
  virtual std::unique_ptr<Member> member(const Campaign& campaign,
                                         std::vector<double> values) const = 0;
  Document document;
};

/// Reads what a campaign varies, by what stands in the file: [impact], [[shot]], [[reference]] or
/// folders of a calibration, or a believed model and data. Files that it names are read here, once.
/// Errors: Error(bad_input) and Error(input_output_failed) with the file that has them.
std::shared_ptr<const Campaign::Base> read_base(Document document);

std::shared_ptr<const Campaign::Base> read_synthesis_base(Document document);
std::shared_ptr<const Campaign::Base> read_calibration_base(Document document);
std::shared_ptr<const Campaign::Base> read_diagnosis_base(Document document);

/// What a member does when it is run. Its refusals of the input, and solvers that end nowhere, are
/// its result.
using MemberWork = std::function<MemberResult(const RunControl&)>;

/// A member whose result has the key of `content`; what `prepare` refuses is its result.
std::unique_ptr<Campaign::Member> make_member(const Campaign& campaign, const std::string& content,
                                              std::vector<double> values,
                                              const std::function<MemberWork()>& prepare);

/// Gives those numbers whose paths are `factors` their values. Both must outlive it.
inline EachNumber::Look setting(const std::vector<CampaignFactor>& factors,
                                const std::vector<double>& values) {
  return [&](const std::string& path, const Key&, double& value) {
    for (std::size_t i = 0; i < factors.size(); ++i)
      if (factors[i].key == path) value = values[i];
  };
}

/// Sets those numbers of `file` whose paths are `factors`, below `path`.
template <class File>
void set_numbers(File& file, const std::vector<CampaignFactor>& factors,
                 const std::vector<double>& values, const std::string& below = {}) {
  const EachNumber::Look look = setting(factors, values);
  EachNumber visitor(look, below);
  describe(static_cast<Visitor&>(visitor), file);
}

/// Every number of `file`, by its path below `below`.
template <class File>
std::vector<Key> numbers_of(const File& file, const std::string& below = {}) {
  std::vector<Key> keys;
  const EachNumber::Look look = [&](const std::string& path, const Key& key, double&) {
    keys.push_back(key);
    keys.back().name = path;
  };
  EachNumber visitor(look, below);
  File copy = file;
  describe(static_cast<Visitor&>(visitor), copy);
  return keys;
}

}  // namespace rebound
