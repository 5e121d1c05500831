#pragma once

#include "lumped/problem/trace.hpp"

namespace rebound {

/// A contact with more samples where it begins and where it ends.
///
///   F(t) = f(w),   w = √t from first touch,   w = √(T − t) towards the end
///
/// The force of a sphere on a still plate is smooth in w and not in t: it begins as t^{3/2}, and a
/// cubic in t between samples at equal times misses it by a fifteenth of the first sample. The
/// first and the last four intervals get sixteen samples at equal distances in w, each from the
/// polynomial in w through the six samples next to that end. All columns are resampled alike.
///
/// Valid:   samples at equal times over one contact, both ends among them;
///          fewer than twelve stay as they are.
///
/// Limit:   t^{3/2}, t^{5/2} and t are met exactly
///          -> test ContactEndsTest.HalfPowersAreExact.
///
/// Caution: for the force on a still plate. What a cell reads under a plate
///          that moves begins so slowly that a cubic in t is the better one;
///          nodes that touch one by one scatter.
Trace with_finer_ends(const Trace& contact);

}  // namespace rebound
