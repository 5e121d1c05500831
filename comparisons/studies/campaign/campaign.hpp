#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "comparisons/io/result_store/stored_member.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/studies/campaign/campaign_design.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// What `rebound campaign FILE` reads: a file that is varied, and what of it is.
struct CampaignFile {
  std::string base;  ///< impact, synthesis, calibration or diagnosis; relative to the campaign file
  bool traces = false;  ///< keep the trace of every impact, too
  CampaignDesign design;
};

void describe(Visitor& visit, CampaignFile& file);

/// A campaign: members by number, each a file with other numbers in it.
///
/// A member is what `rebound lumped`, `fem`, `synthesize`, `calibrate` or `diagnose` gives on such
/// a file, to the same bits -> tests CampaignCommand.AMemberIsTheImpactOfItsFile, CampaignBases.
class Campaign {
 public:
  /// Errors: Error(bad_input) with file, line and key, of either file.
  static Campaign load(const std::filesystem::path& file);
  static Campaign parse(CampaignText text);

  /// A member ready to be run, and the key of its result: SHA-256, cut to 128 bits, over the
  /// effective file, the digests of the files it reads and the version of the program.
  class Member {
   public:
    virtual ~Member() = default;
    /// Errors: Error(interrupted), Error(input_output_failed); any other refusal is a result.
    virtual MemberResult run(const RunControl& control) const = 0;
    std::string key;
    std::vector<double> values;  ///< of the factors [SI]
  };
  /// May be called from several threads at once.
  std::unique_ptr<Member> member(std::vector<double> values) const;

  bool keeps_traces() const { return file_.traces; }
  const CampaignDesign& design() const { return file_.design; }
  const CampaignText& text() const { return text_; }
  std::string digest() const;  ///< of the texts of both files
  std::size_t size() const { return member_count(file_.design); }
  const std::string& program() const { return program_; }

  bool of_impacts() const;  ///< do its members give scalars, or values with names?

  struct Base;  ///< the file that is varied

 private:
  CampaignText text_;
  CampaignFile file_;
  std::string program_;
  std::shared_ptr<const Base> base_;
};

using CampaignMembers = std::vector<std::unique_ptr<Campaign::Member>>;

/// Members of a design by their numbers, made by all threads.
CampaignMembers make_members(const Campaign& campaign, DesignSampler& sampler,
                             const std::vector<std::size_t>& numbers);

}  // namespace rebound
