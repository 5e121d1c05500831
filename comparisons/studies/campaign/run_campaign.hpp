#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "comparisons/io/results/json.hpp"
#include "comparisons/studies/campaign/campaign.hpp"
#include "comparisons/studies/campaign/shard.hpp"

namespace rebound {

struct CampaignProgress {
  std::size_t members = 0;       ///< of the shard
  std::size_t found = 0;         ///< that were in the store
  std::size_t run = 0;           ///< that were run now
  std::size_t failed = 0;        ///< of all these, without a result
  double impact_seconds = 0.0;   ///< in impacts, summed over threads
  double elapsed_seconds = 0.0;  ///< of the whole
  /// Processor time of the impacts, and of all from the first look into the store [s]: what a busy
  /// machine does not lengthen.
  double impact_processor_seconds = 0.0, processor_seconds = 0.0;
  int threads = 1;
  std::filesystem::path file;

  /// Time of a thread that went into no impact, a member that was run [s].
  double overhead_per_member() const;
};

Json to_json(const CampaignProgress& progress);

/// Runs the members of a shard whose results are not in `store` (a folder) and keeps each there.
///
/// Results are kept every 100 ms as members end, less often where that would cost more than a
/// fiftieth of the time, but every second: a killed process loses what was run since. A shard
/// writes to a file of its own; results in files of other divisions of the same folder are used.
/// Memory does not grow with the members -> README, and the sampler's own. Errors:
/// Error(interrupted) after what was run is kept; those of ResultStore.
CampaignProgress run_campaign(const Campaign& campaign, const std::filesystem::path& store,
                              const Shard& shard, const RunControl& control);

}  // namespace rebound
