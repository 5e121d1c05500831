#include <fmt/format.h>

#include "comparisons/discrepancy/inspection/inspection_output.hpp"
#include "comparisons/models/instrument/channel_filter.hpp"

namespace rebound {
namespace {

std::string with_error(double value, const std::optional<double>& error) {
  return error ? fmt::format("{:.5g} +- {:.2g}", value, *error) : fmt::format("{:.5g}", value);
}

std::string interval_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.4g} us", 1e6 * seconds);
  return seconds < 1.0 ? fmt::format("{:.4g} ms", 1e3 * seconds) : fmt::format("{:.4g} s", seconds);
}

std::string shot_text(const InspectedShot& shot) {
  std::string text = fmt::format("{}\n", shot.label);
  if (shot.samples > 0)
    text += fmt::format("  record    {} samples, {} in contact, every {}\n", shot.samples,
                        shot.samples_in_contact, interval_text(shot.interval));
  for (const InspectedNumber& number : shot.numbers)
    text += fmt::format("  {:<36}{}\n", number.key, with_error(number.value, number.uncertainty));
  for (const FilteredPeak& one : shot.filters)
    text +=
        fmt::format("  peak after CFC {:<21}{:+.2f} %\n", one.channel_class, 100.0 * one.change);
  for (const std::string& reason : shot.too_coarse)
    text += fmt::format("  TOO COARSE  {}\n", reason);
  return text;
}

std::string noise_text(const InspectedNoise& noise) {
  std::string text = fmt::format("noise from  {}\n", noise.from);
  if (!(noise.deviation > 0.0)) return text;
  text += fmt::format("  {:.3g} N a sample, from {} samples before contact, ", noise.deviation,
                      noise.samples);
  if (noise.autocorrelation.empty()) return text + "white\n";
  return text + fmt::format("coloured: neighbours correlate by {:.2f}, order {}\n",
                            noise.autocorrelation.front(), noise.autocorrelation.size());
}

}  // namespace

std::string to_text(const Inspection& found) {
  std::string text = fmt::format("{}: {} shots\n", found.name, found.shots.size());
  if (found.checks.empty())
    text += "nothing in these data is said twice: no contradiction could show\n";
  else if (found.contradictions.empty())
    text += fmt::format("no contradiction in {} checks (limit {:.1f} standard deviations)\n",
                        found.checks.size(), found.contradiction_limit);
  for (const DataCheck& one : found.contradictions)
    text += fmt::format(
        "CONTRADICTION  {} of {}: {:.4g}, expected {:.4g} ({:+.1f} standard "
        "deviations){}{}\n",
        one.what, one.of, one.measured, one.expected, one.deviations(),
        one.mended_by.empty() ? "" : "; mended by ", one.mended_by);
  text += noise_text(found.noise);
  for (const InspectedShot& shot : found.shots) text += shot_text(shot);
  for (const RepeatedSpeed& one : found.repeats)
    text +=
        fmt::format("repeats at {:.4g} m/s  {}: {:.5g}, scatter {:.2g} of {}{}\n", one.speed,
                    one.key, one.mean, one.scatter, one.count,
                    one.typical_error ? fmt::format(", stated {:.2g}", *one.typical_error) : "");
  for (const std::string& warning : found.warnings) text += "warning   " + warning + "\n";
  for (const std::string& missing : found.missing) text += "missing   " + missing + "\n";
  return text;
}

}  // namespace rebound
