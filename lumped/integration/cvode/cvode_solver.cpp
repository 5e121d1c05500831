#include "lumped/integration/cvode/cvode_solver.hpp"

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

int rate(realtype, N_Vector y, N_Vector y_rate, void* data) {
  const auto& system = *static_cast<CvodeSystem*>(data);
  double* values = N_VGetArrayPointer(y_rate);
  system.rate(N_VGetArrayPointer(y), values);
  const bool fine =
      std::all_of(values, values + system.size, [](double value) { return std::isfinite(value); });
  return fine ? 0 : 1;  // 1: try a shorter step
}

int indicators(realtype, N_Vector y, realtype* values, void* data) {
  static_cast<CvodeSystem*>(data)->indicators(N_VGetArrayPointer(y), values);
  return 0;
}

int variation(int, realtype, N_Vector y, N_Vector, int direction, N_Vector s, N_Vector s_rate,
              void* data, N_Vector, N_Vector) {
  const auto& system = *static_cast<CvodeSystem*>(data);
  double* values = N_VGetArrayPointer(s_rate);
  system.variation(N_VGetArrayPointer(y), static_cast<std::size_t>(direction),
                   N_VGetArrayPointer(s), values);
  const bool fine =
      std::all_of(values, values + system.size, [](double value) { return std::isfinite(value); });
  return fine ? 0 : 1;
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
struct CvodeSolver::Handles {
  CvodeSystem system;
  SUNContext context = nullptr;
  N_Vector y = nullptr, tolerance = nullptr;
  N_Vector* variations = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear = nullptr;
  void* cvode = nullptr;
  std::size_t event_count = 0;

  explicit Handles(CvodeSystem the_system) : system(std::move(the_system)) {
    const auto size = static_cast<sunindextype>(system.size);
    check(SUNContext_Create(nullptr, &context), "creating a context");
    y = created(N_VNew_Serial(size, context), "creating a vector");
    tolerance = created(N_VNew_Serial(size, context), "creating a vector");
    matrix = created(SUNDenseMatrix(size, size, context), "creating a matrix");
    linear = created(SUNLinSol_Dense(y, matrix, context), "creating a linear solver");
    cvode = CVodeCreate(CV_ADAMS, context);
    if (!cvode) fail("creating the solver", "out of memory");
  }
  ~Handles() {
    if (cvode) CVodeFree(&cvode);
    if (linear) SUNLinSolFree(linear);
    if (matrix) SUNMatDestroy(matrix);
    if (variations) N_VDestroyVectorArray(variations, static_cast<int>(system.directions));
    if (tolerance) N_VDestroy(tolerance);
    if (y) N_VDestroy(y);
    if (context) SUNContext_Free(&context);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
};

CvodeSolver::CvodeSolver(CvodeSystem system, const CvodeTolerances& tolerances,
                         std::span<const double> initial)
    : handles_(std::make_unique<Handles>(std::move(system))) {
  Handles& h = *handles_;
  std::copy(initial.begin(), initial.end(), state());
  std::copy(tolerances.absolute.begin(), tolerances.absolute.end(),
            N_VGetArrayPointer(h.tolerance));
  check(CVodeInit(h.cvode, rate, 0.0, h.y), "starting");
  check(CVodeSetErrHandlerFn(h.cvode, stay_silent, nullptr), "starting");
  check(CVodeSetUserData(h.cvode, &h.system), "starting");
  check(CVodeSVtolerances(h.cvode, tolerances.relative, h.tolerance), "starting");
  check(CVodeSetLinearSolver(h.cvode, h.linear, h.matrix), "starting");
  check(CVodeSetNonlinConvCoef(h.cvode, tolerances.newton), "starting");
  check(CVodeSetMaxNumSteps(h.cvode, 1'000'000), "starting");
  if (h.system.directions == 0) return;
  const auto directions = static_cast<int>(h.system.directions);
  h.variations = created(N_VCloneVectorArray(directions, h.y), "creating vectors");
  for (int i = 0; i < directions; ++i) N_VConst(0.0, h.variations[i]);
  check(CVodeSensInit1(h.cvode, directions, CV_SIMULTANEOUS, rebound::variation, h.variations),
        "starting the sensitivities");
  std::vector<double> sizes = tolerances.parameter_sizes;
  check(CVodeSetSensParams(h.cvode, nullptr, sizes.data(), nullptr), "starting the sensitivities");
  check(CVodeSensEEtolerances(h.cvode), "starting the sensitivities");
  check(CVodeSetSensErrCon(h.cvode, SUNTRUE), "starting the sensitivities");
}

CvodeSolver::~CvodeSolver() = default;

double* CvodeSolver::variation(std::size_t direction) {
  return N_VGetArrayPointer(handles_->variations[direction]);
}

double* CvodeSolver::state() {
  return N_VGetArrayPointer(handles_->y);
}

void CvodeSolver::restart(double time, std::span<const int> directions) {
  Handles& h = *handles_;
  h.event_count = directions.size();
  check(CVodeReInit(h.cvode, time, h.y), "restarting");
  if (h.variations) check(CVodeSensReInit(h.cvode, CV_SIMULTANEOUS, h.variations), "restarting");
  check(
      CVodeRootInit(h.cvode, static_cast<int>(h.event_count), h.event_count ? indicators : nullptr),
      "restarting");
  if (h.event_count == 0) return;
  std::vector<int> copy(directions.begin(), directions.end());  // CVODE wants it writable
  check(CVodeSetRootDirection(h.cvode, copy.data()), "restarting");
}

CvodeSolver::Reached CvodeSolver::advance(double time, const char* doing) {
  Handles& h = *handles_;
  Reached reached;
  const int flag = CVode(h.cvode, time, h.y, &reached.time, CV_NORMAL);
  check(flag, doing);
  if (h.variations) check(CVodeGetSens(h.cvode, &reached.time, h.variations), doing);
  reached.at_event = flag == CV_ROOT_RETURN;
  if (!reached.at_event) return reached;
  std::vector<int> found(h.event_count);
  check(CVodeGetRootInfo(h.cvode, found.data()), doing);
  for (const int sign : found) reached.events.push_back(sign != 0);
  return reached;
}

}  // namespace rebound
