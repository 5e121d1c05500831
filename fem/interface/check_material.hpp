#pragma once

#include <string>
#include <vector>

#include "fem/interface/material.hpp"

namespace rebound {

/// Holds a material to the limits of its numbers and to what they must be together:
/// instantaneous shares that sum below 1, terms that fit one another and ν, factors of
/// strain beside branches that relax all of the stress, layers from the inside outward.
/// Errors: Error(bad_input) with the full path of the key, its value and what is allowed.
void check(const Material& material, const KeyPath& at = {"model.material"});

/// Has the material nothing but an elastic law and branches by convolution?
bool convolution_alone(const Material& material);

/// Refuses, under `key`, what the nine-node cells have no update for.
void check_convolution_alone(const Material& material, const std::string& key);

/// βᵢ of a hyperfoam before anything has relaxed: as given, moved together to the bulk
/// modulus of that state. Empty for other laws.
std::vector<double> instantaneous_betas(const Material& material);

}  // namespace rebound
