#pragma once

#include <filesystem>
#include <string>

#include "comparisons/io/results/provenance.hpp"
#include "fem/interface/compression.hpp"
#include "fem/interface/fem_result.hpp"
#include "lumped/problem/result.hpp"

namespace rebound {

/// Everything of a result folder but the result itself.
struct ResultFolder {
  std::filesystem::path folder;
  std::string effective_toml;  ///< configuration with every default written out
  Provenance provenance;
  Json further_keys = {};  ///< of result.json, e.g. error bars
};

/// Writes effective.toml, trace.csv and, last, result.json: where result.json
/// stands, the rest is complete. Each file is written atomically.
/// Errors: Error(input_output_failed).
void write_result(const ResultFolder& target, const LumpedResult& result);

/// An FE result that ended early gives effective.toml, trace-incomplete.csv
/// and incomplete.json, which says why and reports no scalar; any result.json
/// and trace.csv of an earlier run in that folder are removed first.
void write_result(const ResultFolder& target, const FemResult& result);

/// A compression gives curve.csv where an impact gives trace.csv.
void write_result(const ResultFolder& target, const CompressionResult& result);

}  // namespace rebound
