#include "comparisons/io/dataset/guess_trace.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <string>

#include "comparisons/io/dataset/contact_window.hpp"
#include "comparisons/io/laboratory/row_window.hpp"

namespace rebound {
namespace {

bool starts_like(const std::string& name, const std::vector<std::string>& starts) {
  std::string text;
  for (const char sign : name)
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(sign)));
  return std::any_of(starts.begin(), starts.end(), [&](const std::string& start) {
    return start.size() == 1 ? text == start : text.starts_with(start);
  });
}

/// "Kraft [tonf]": what stands in the brackets is no unit that is known, so that none is guessed.
bool states_unknown_unit(const ColumnHeading& heading) {
  const std::size_t open = heading.text.rfind('[');
  return heading.unit.empty() && open != std::string::npos && heading.text.ends_with(']') &&
         heading.text.find_first_not_of("[]?- ", open) != std::string::npos;
}

std::optional<ChannelGuess> guess_channel(const TablePreview& preview, std::size_t i) {
  if (!preview.is_number[i]) return std::nullopt;
  const ColumnHeading& heading = preview.headings[i];
  const bool named_acceleration = starts_like(heading.name, {"acc", "a", "decel", "a1", "a2"});
  if (!heading.unit.empty()) {
    const auto unit = find_unit(
        heading.unit, named_acceleration ? std::optional(dimension::acceleration) : std::nullopt);
    if (!unit) return std::nullopt;
    return ChannelGuess{i, unit->dimension, false};
  }
  if (states_unknown_unit(heading)) return std::nullopt;
  if (starts_like(heading.name, {"time", "t", "zeit"}))
    return ChannelGuess{i, dimension::time, true};
  if (starts_like(heading.name, {"force", "f", "kraft", "load"}))
    return ChannelGuess{i, dimension::force, true};
  if (named_acceleration) return ChannelGuess{i, dimension::acceleration, true};
  return std::nullopt;
}

std::vector<std::string> columns_not_used(const TablePreview& preview, const TraceGuess& guess) {
  std::vector<std::string> remarks;
  for (std::size_t i = 0; i < preview.headings.size(); ++i) {
    const auto is_here = [&](const ChannelGuess& channel) { return channel.column == i; };
    if (is_here(guess.time) || (guess.deflection && is_here(*guess.deflection)) ||
        std::any_of(guess.forces.begin(), guess.forces.end(), is_here))
      continue;
    const ColumnHeading& heading = preview.headings[i];
    remarks.push_back(heading.text + (!preview.is_number[i]          ? ": not all of it is numbers"
                                      : states_unknown_unit(heading) ? ": its unit is not known"
                                      : heading.unit.empty()
                                          ? ": no known name, and no unit"
                                          : ": another one is, or another kind"));
  }
  return remarks;
}

}  // namespace

std::optional<TraceGuess> guess_trace(const TablePreview& preview) {
  constexpr std::size_t fewest_rows = 20;
  if (preview.rows < fewest_rows) return std::nullopt;
  TraceGuess guess;
  bool has_time = false;
  for (std::size_t i = 0; i < preview.headings.size(); ++i) {
    const auto channel = guess_channel(preview, i);
    if (!channel) continue;
    if (same_dimension(channel->dimension, dimension::time)) {
      if (!has_time) guess.time = *channel;
      has_time = true;
    } else if (same_dimension(channel->dimension, dimension::force) ||
               same_dimension(channel->dimension, dimension::acceleration)) {
      guess.forces.push_back(*channel);
    } else if (same_dimension(channel->dimension, dimension::length) && !guess.deflection) {
      guess.deflection = channel;
    }
  }
  if (!has_time || guess.forces.empty()) return std::nullopt;
  // One kind only: a force where there is one.
  const bool any_force = std::any_of(guess.forces.begin(), guess.forces.end(), [](const auto& one) {
    return same_dimension(one.dimension, dimension::force);
  });
  if (any_force)
    std::erase_if(guess.forces, [](const ChannelGuess& one) {
      return !same_dimension(one.dimension, dimension::force);
    });
  guess.remarks = columns_not_used(preview, guess);
  return guess;
}

const char* usual_unit(const Dimension& dimension) {
  if (same_dimension(dimension, dimension::time)) return "s";
  if (same_dimension(dimension, dimension::force)) return "N";
  return same_dimension(dimension, dimension::length) ? "m" : "m/s^2";
}

RecordGuess look_at_record(const std::filesystem::path& file, const TablePreview& preview,
                           const TraceGuess& trace) {
  const auto wanted = [&](const ChannelGuess& channel) {
    const ColumnHeading& heading = preview.headings[channel.column];
    return WantedColumn{.heading = heading.text,
                        .accepted = {channel.dimension},
                        .unit = channel.unit_guessed ? usual_unit(channel.dimension) : ""};
  };
  WantedColumn time = wanted(trace.time);
  time.increases = true;
  LaboratoryTable table =
      read_laboratory_table(file, {time, wanted(trace.forces.front())}, rows_of_a_record(1));
  std::vector<double>& force = table.columns[1].numbers;
  RecordGuess guess;
  const std::size_t tenth = std::max<std::size_t>(force.size() / 10, 2);
  const auto quiet_end = force.begin() + static_cast<std::ptrdiff_t>(tenth);
  const auto count = static_cast<double>(tenth);
  const double mean = std::accumulate(force.begin(), quiet_end, 0.0) / count;
  double variance = 0.0;
  for (auto it = force.begin(); it != quiet_end; ++it)
    variance += (*it - mean) * (*it - mean) / (count - 1.0);
  const auto [lowest, highest] = std::minmax_element(force.begin(), force.end());
  guess.reversed = mean - *lowest > *highest - mean;
  guess.offset = std::abs(mean) > 3.0 * std::sqrt(variance / count) && mean != 0.0;
  for (double& value : force) value = guess.reversed ? mean - value : value - mean;
  const double peak = *std::max_element(force.begin(), force.end());
  if (peak > 0.0)
    guess.long_record =
        20 * contact_window(force, clearly_in_contact * peak).count() < table.rows_read;
  return guess;
}

}  // namespace rebound
