#pragma once

#include <algorithm>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

/// kp and kd of Gazebo Classic's ODE: stiffnesses in series, dampings added
/// (gazebo/physics/ode/ODEPhysics.cc); a wall that says nothing has kp 1e12 N/m and kd 1 N s/m.
namespace rebound {

inline double gazebo_kd(const CodeContact& contact) {
  return std::max(0.0, contact.at("damping") - 1.0);
}

inline std::vector<ConvertedParameter> gazebo_settings(const CodeContact& contact) {
  return {{"kp", contact.at("stiffness"), "N/m"},
          {"kd", gazebo_kd(contact), "N.s/m"},
          {"max_step_size", contact.step, "s"}};
}

inline constexpr const char* gazebo_force =
    "f = kp d + kd d', never below 0, at the end of each step";

}  // namespace rebound
