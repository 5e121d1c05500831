#include "lumped/integration/cvode_integrator.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

/// What CVODE calls back into.
struct Callbacks {
  const ContactSystem* system;
  SeparationRule separation;
};

int rate(realtype, N_Vector y, N_Vector y_rate, void* data) {
  static_cast<Callbacks*>(data)->system->derivative(N_VGetArrayPointer(y),
                                                    N_VGetArrayPointer(y_rate));
  return 0;
}

int separation_roots(realtype, N_Vector y, realtype* root, void* data) {
  const auto& callbacks = *static_cast<Callbacks*>(data);
  const double* state = N_VGetArrayPointer(y);
  root[0] = state[ContactSystem::deflection];
  if (callbacks.separation == SeparationRule::zero_force)
    root[1] = callbacks.system->force(state);
  return 0;
}

// CVODE would print on standard error; the failure is thrown instead.
void stay_silent(int, const char*, const char*, char*, void*) {}

[[noreturn]] void fail(const std::string& doing, const std::string& reason) {
  throw Error(ExitCode::solver_failed, "CVODE failed while " + doing + ": " + reason);
}

void check(int flag, const char* doing) {
  if (flag >= 0) return;
  char* name = CVodeGetReturnFlagName(flag);
  const std::string reason = name ? name : "unknown";
  std::free(name);
  fail(doing, reason);
}

template <class Handle>
Handle* created(Handle* handle, const char* doing) {
  if (!handle) fail(doing, "out of memory");
  return handle;
}

}  // namespace

/// Owner of CVODE's handles; destroyed in reverse order of creation.
struct CvodeIntegrator::Solver {
  SUNContext context = nullptr;
  N_Vector y = nullptr, tolerance = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear = nullptr;
  void* cvode = nullptr;
  Callbacks callbacks{};

  Solver() {
    check(SUNContext_Create(nullptr, &context), "creating a context");
    y = created(N_VNew_Serial(ContactSystem::states, context), "creating a vector");
    tolerance = created(N_VNew_Serial(ContactSystem::states, context), "creating a vector");
    matrix = created(SUNDenseMatrix(ContactSystem::states, ContactSystem::states, context),
                     "creating a matrix");
    linear = created(SUNLinSol_Dense(y, matrix, context), "creating a linear solver");
    cvode = CVodeCreate(CV_ADAMS, context);
    if (!cvode) fail("creating the solver", "out of memory");
  }
  ~Solver() {
    if (cvode) CVodeFree(&cvode);
    if (linear) SUNLinSolFree(linear);
    if (matrix) SUNMatDestroy(matrix);
    if (tolerance) N_VDestroy(tolerance);
    if (y) N_VDestroy(y);
    if (context) SUNContext_Free(&context);
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  double* state() { return N_VGetArrayPointer(y); }
};

CvodeIntegrator::CvodeIntegrator(const AnyLaw& law, const ContactSetup& setup)
    : system_{law, setup.mass},
      setup_(setup),
      scales_(std::visit([&](const auto& l) { return contact_scales(l, setup); }, law)),
      solver_(std::make_unique<Solver>()) {
  solver_->callbacks = {&system_, setup_.separation};
  restart();
  void* cvode = solver_->cvode;
  check(CVodeInit(cvode, rate, 0.0, solver_->y), "starting");
  check(CVodeSetErrHandlerFn(cvode, stay_silent, nullptr), "starting");
  check(CVodeSetUserData(cvode, &solver_->callbacks), "starting");
  const double energy = 0.5 * setup.mass * setup.speed * setup.speed;
  double* absolute = N_VGetArrayPointer(solver_->tolerance);
  absolute[ContactSystem::deflection] = setup.relative_tolerance * scales_.deflection;
  absolute[ContactSystem::velocity] = setup.relative_tolerance * setup.speed;
  absolute[ContactSystem::impulse] = setup.relative_tolerance * setup.mass * setup.speed;
  absolute[ContactSystem::dissipated] = setup.relative_tolerance * energy;
  check(CVodeSVtolerances(cvode, setup.relative_tolerance, solver_->tolerance), "starting");
  check(CVodeSetLinearSolver(cvode, solver_->linear, solver_->matrix), "starting");
  check(CVodeSetMaxNumSteps(cvode, 1'000'000), "starting");
}

CvodeIntegrator::~CvodeIntegrator() = default;

void CvodeIntegrator::restart() {
  double* y = solver_->state();
  std::fill_n(y, static_cast<int>(ContactSystem::states), 0.0);
  y[ContactSystem::velocity] = setup_.speed;
}

ContactEnd CvodeIntegrator::integrate() {
  void* cvode = solver_->cvode;
  restart();
  check(CVodeReInit(cvode, 0.0, solver_->y), "restarting");
  const int roots = setup_.separation == SeparationRule::zero_force ? 2 : 1;
  std::array<int, 2> falling = {-1, -1};
  check(CVodeRootInit(cvode, roots, separation_roots), "watching for separation");
  check(CVodeSetRootDirection(cvode, falling.data()), "watching for separation");
  double time = 0.0;
  const int flag =
      CVode(cvode, longest_contact * scales_.time, solver_->y, &time, CV_NORMAL);
  check(flag, "integrating the contact");
  if (flag != CV_ROOT_RETURN) throw contact_does_not_end();
  double* y = solver_->state();
  std::array<int, 2> found = {0, 0};
  check(CVodeGetRootInfo(cvode, found.data()), "locating the separation");
  if (found[0] != 0) y[ContactSystem::deflection] = 0.0;  // what is left is rounding
  const ContactEnd end = {time, y[ContactSystem::deflection], y[ContactSystem::velocity],
                y[ContactSystem::impulse], y[ContactSystem::dissipated]};
  require_rebound(end, setup_);
  return end;
}

Trace CvodeIntegrator::sample(const ContactEnd& end, int samples) {
  void* cvode = solver_->cvode;
  restart();
  check(CVodeReInit(cvode, 0.0, solver_->y), "restarting");
  check(CVodeRootInit(cvode, 0, nullptr), "restarting");
  Trace trace;
  const auto record = [&](double time) {
    trace.time.push_back(time);
    trace.force.push_back(system_.force(solver_->state()));
    trace.deflection.push_back(solver_->state()[ContactSystem::deflection]);
  };
  record(0.0);
  for (int i = 1; i + 1 < samples; ++i) {
    const double instant = end.time * i / (samples - 1);
    double reached = 0.0;
    check(CVode(cvode, instant, solver_->y, &reached, CV_NORMAL), "sampling the contact");
    record(instant);
  }
  solver_->state()[ContactSystem::deflection] = end.deflection;
  solver_->state()[ContactSystem::velocity] = end.velocity;
  record(end.time);
  return trace;
}

}  // namespace rebound
