#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/accuracy/tier_comparison/tier_record.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// The file of a case's baseline: schema, case, records [{tier, speed_m_s, separation_rule,
/// input_sha256, discretisation {scheme, cells, vertices, smallest_step_s}, scalars {key: {value,
/// rounding, step, numerical}}}]. One small file a case, so that a diff of it is readable.
std::filesystem::path baseline_file(const std::filesystem::path& folder, const std::string& name);

Json to_json(const TierRecord& record);

/// Writes a baseline whole or not at all.
void write_baseline(const std::filesystem::path& folder, const std::string& name,
                    const std::vector<TierRecord>& records);

/// Errors: Error(bad_input) where there is none; Error(corrupt_store) for a file that is no whole
///         baseline of that case.
std::vector<TierRecord> read_baseline(const std::filesystem::path& folder, const std::string& name);

}  // namespace rebound
