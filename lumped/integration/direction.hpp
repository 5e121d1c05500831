#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace rebound {

/// What a derivative of an impact is taken by.
struct Direction {
  enum class Of { nothing, law, mass, speed };
  Of of = Of::nothing;
  std::size_t parameter = 0;  ///< of the law, in the order of its card
};

/// Most directions that are followed at once: four parameters of a law, mass and speed.
inline constexpr std::size_t most_directions = 6;

/// Calls `use` with an array of two, four or six directions, filled up with nothing: the
/// integrator is compiled for these widths, or for those of them from `Least` on.
/// Errors: none; at most `most_directions` are taken.
template <std::size_t Least = 1, class Use>
decltype(auto) with_width(std::span<const Direction> by, Use&& use) {
  const auto filled = [&]<std::size_t Width>(std::array<Direction, Width> directions) {
    std::copy_n(by.begin(), std::min(by.size(), Width), directions.begin());
    return directions;
  };
  if constexpr (Least <= 2)
    if (by.size() <= 2) return use(filled(std::array<Direction, 2>{}));
  if (by.size() <= 4) return use(filled(std::array<Direction, 4>{}));
  return use(filled(std::array<Direction, most_directions>{}));
}

}  // namespace rebound
