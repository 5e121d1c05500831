#include "comparisons/studies/campaign/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t most_shards = 100'000;

std::size_t whole_of(std::string_view text) {
  std::size_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc{} && end == text.data() + text.size() ? value : 0;
}

}  // namespace

std::size_t member_in_round(const Shard& shard, std::size_t round) {
  // The mixing step of SplitMix64 (Steele, Lea & Flood 2014).
  std::uint64_t mixed = (round + 1) * 0x9e3779b97f4a7c15ULL;
  mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebULL;
  mixed ^= mixed >> 31U;
  return round * shard.of + (shard.number - 1 + mixed % shard.of) % shard.of;
}

std::size_t members_of(const Shard& shard, std::size_t all) {
  const std::size_t rounds = all / shard.of;
  return rounds + (member_in_round(shard, rounds) < all ? 1 : 0);
}

Shard parse_shard(const std::string& text) {
  const auto slash = std::min(text.find('/'), text.size());
  const Shard shard{
      .number = whole_of(std::string_view(text).substr(0, slash)),
      .of = slash < text.size() ? whole_of(std::string_view(text).substr(slash + 1)) : 0};
  if (shard.number >= 1 && shard.number <= shard.of && shard.of <= most_shards) return shard;
  throw Error(ExitCode::bad_input, "which part of the campaign?",
              {.key = "--shard", .value = text, .allowed = "i/N with 1 <= i <= N <= 100000"});
}

Shard shard_of_launcher() {
  for (const auto& [rank, size] : {std::pair{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                   std::pair{"PMI_RANK", "PMI_SIZE"}}) {
    const char* rank_text = std::getenv(rank);
    const char* size_text = std::getenv(size);
    if (rank_text && size_text)
      return parse_shard(fmt::format("{}/{}", whole_of(rank_text) + 1, size_text));
  }
  return {};
}

}  // namespace rebound
