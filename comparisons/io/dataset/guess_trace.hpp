#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "comparisons/io/laboratory/laboratory_table.hpp"

/// What the columns and numbers of a file look like, if it is a trace.
namespace rebound {

/// A column of a trace, with its unit or a guess of it.
struct ChannelGuess {
  std::size_t column = 0;
  Dimension dimension;
  bool unit_guessed = false;
};

/// What a trace file seems to hold.
struct TraceGuess {
  ChannelGuess time;
  std::vector<ChannelGuess> forces;  ///< of one kind: forces where there are any, or accelerations
  std::optional<ChannelGuess> deflection;
  std::vector<std::string> remarks;  ///< columns that are not used, and why
};

/// Nothing where no time stands beside a force or an acceleration in 20 rows or more.
std::optional<TraceGuess> guess_trace(const TablePreview& preview);

/// SI unit that a heading without one is taken to mean.
const char* usual_unit(const Dimension& dimension);

/// What the numbers of the first force channel say; guess_dataset.hpp has the rules.
struct RecordGuess {
  bool reversed = false, offset = false, long_record = false;
};
RecordGuess look_at_record(const std::filesystem::path& file, const TablePreview& preview,
                           const TraceGuess& trace);

}  // namespace rebound
