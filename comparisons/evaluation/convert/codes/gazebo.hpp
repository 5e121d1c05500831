#pragma once

#include <algorithm>
#include <cmath>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

/// kp and kd of Gazebo Classic's ODE: stiffnesses in series, dampings added, then
/// ERP = h kp/(h kp + kd) and CFM = 1/(h kp + kd) with h = max_step_size
/// (gazebo/physics/ode/ODEPhysics.cc, Collide()); a wall that says nothing has kp 1e12 N/m and
/// kd 1 N s/m (SDFormat, surface/contact/ode). The speed ERP x/h that is asked of a step is cut at
/// max_vel of the surface and at contact_max_correcting_vel of the world, 100 m/s where nothing is
/// said (deps/opende/src/joints/contact.cpp); min_depth of the surface stands above
/// contact_surface_layer of the world there.
namespace rebound {

inline double gazebo_kd(const CodeContact& contact) {
  return std::max(0.0, contact.at("damping") - 1.0);
}

/// A limit above every ERP x/h: ten times the elastic deflection a step [m/s].
///
///   10 v √(m/kp)/h
inline double gazebo_max_speed(const CodeContact& contact) {
  return 10.0 * contact.speed * std::sqrt(contact.sphere.mass / contact.at("stiffness")) /
         contact.step;
}

inline std::vector<ConvertedParameter> gazebo_settings(const CodeContact& contact) {
  return {{"kp", contact.at("stiffness"), "N/m"},
          {"kd", gazebo_kd(contact), "N.s/m"},
          {"max_step_size", contact.step, "s"}};
}

inline constexpr const char* gazebo_force =
    "f = kp d + kd d', never below 0, at the end of each step";

}  // namespace rebound
