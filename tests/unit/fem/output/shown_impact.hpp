#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "fem/explicit/explicit_impact.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/vtu.hpp"

namespace rebound::fem::field_tests {

inline const Discretisation& sphere_of_frames() {
  static const Discretisation body =
      discretise(generate_sphere_mesh({.radius = 0.0331, .cells = 200}), 0.0896);
  return body;
}

/// An impact and the frames it wrote.
struct Shown {
  FemResult result;
  std::vector<test::Vtu> frames;
};

inline Shown shown_impact(const Discretisation& body, FemProblem problem, int frames) {
  testing::TemporaryFolder folder;
  problem.controls.field_frames = frames;
  problem.controls.field_directory = (folder.path() / "fields").string();
  Shown shown{run_explicit_impact(body, problem, {}), {}};
  EXPECT_EQ(shown.result.incomplete_because, "");
  for (const auto& [time, file] : test::read_pvd(folder.path() / "fields/impact.pvd")) {
    shown.frames.push_back(test::read_vtu(folder.path() / "fields" / file));
    EXPECT_EQ(shown.frames.back().time, time);
  }
  return shown;
}

/// The lower half of the outline, from the pole outward.
inline std::vector<int> underside(const Discretisation& body) {
  std::vector<int> nodes;
  for (const int node : body.contact_nodes)
    if (body.position[node][1] < 0.0331) nodes.push_back(node);
  return nodes;
}

}  // namespace rebound::fem::field_tests
