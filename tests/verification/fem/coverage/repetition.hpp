#pragma once

#include <filesystem>

namespace rebound {

/// Runs `count` judged families of the stored table again, drawn from a fixed seed, and prints of
/// each scalar by how much its value, its bar and the verdict differ. Writes nothing.
/// Returns how many verdicts differ.
/// Errors: those of read_coverage() and run_family().
int repeat_families(const std::filesystem::path& table, int count);

}  // namespace rebound
