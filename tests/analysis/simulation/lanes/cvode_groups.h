// CVODE on the dimensionless equations of the one-state slip law, counted from steady sliding: independent of the
// product's own solver, and free of the rounding of forces that hides the growth of joints near their boundary.
#pragma once
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "analysis/results/disturbance.h"
#include "analysis/simulation/flows/growth_window.h"
#include "analysis/simulation/lanes/job.h"

namespace stickslip {

/// Three unknowns, quiet, dense, BDF.
struct CvodeSolver {
    SUNContext context = nullptr;
    N_Vector y = nullptr, tolerance = nullptr;
    SUNMatrix matrix = nullptr;
    SUNLinearSolver linear = nullptr;
    void* cvode = nullptr;

    explicit CvodeSolver(CVRhsFn rate)
    {
#if SUNDIALS_VERSION_MAJOR >= 7
        SUNContext_Create(SUN_COMM_NULL, &context);
        SUNContext_ClearErrHandlers(context);
#else
        SUNContext_Create(nullptr, &context);
#endif
        y = N_VNew_Serial(3, context);
        tolerance = N_VNew_Serial(3, context);
        N_VConst(0, y);
        cvode = CVodeCreate(CV_BDF, context);
#if SUNDIALS_VERSION_MAJOR < 7
        CVodeSetErrHandlerFn(
            cvode, [](int, const char*, const char*, char*, void*) {}, nullptr);
#endif
        CVodeInit(cvode, rate, 0, y);
        matrix = SUNDenseMatrix(3, 3, context);
        linear = SUNLinSol_Dense(y, matrix, context);
        CVodeSetLinearSolver(cvode, linear, matrix);
        CVodeSetMaxNumSteps(cvode, 1000000);
    }
    ~CvodeSolver()
    {
        CVodeFree(&cvode);
        SUNLinSolFree(linear);
        SUNMatDestroy(matrix);
        N_VDestroy(tolerance);
        N_VDestroy(y);
        SUNContext_Free(&context);
    }
    CvodeSolver(const CvodeSolver&) = delete;
    CvodeSolver& operator=(const CvodeSolver&) = delete;
};

/// The equations of lanes::Groups, which `user` points to.
inline int groups_rate(double, N_Vector y, N_Vector out, void* user)
{
    const auto& g = *static_cast<lanes::Groups*>(user);
    const double *s = NV_DATA_S(y), v = std::exp(s[1]), excess = std::expm1(s[1]);
    double* d = NV_DATA_S(out);
    d[0] = excess;
    d[1] = -(g.c * excess + g.K * s[0] + s[1] + s[2]) / (g.M * v);
    d[2] = -v * (s[2] + g.beta * s[1]);
    return 0;
}

inline int groups_jacobian(double, N_Vector y, N_Vector, SUNMatrix J, void* user, N_Vector, N_Vector, N_Vector)
{
    const auto& g = *static_cast<lanes::Groups*>(user);
    const double *s = NV_DATA_S(y), v = std::exp(s[1]), per_Mv = 1 / (g.M * v);
    const double rate = -(g.c * (v - 1) + g.K * s[0] + s[1] + s[2]) * per_Mv;
    SM_ELEMENT_D(J, 0, 0) = 0, SM_ELEMENT_D(J, 0, 1) = v, SM_ELEMENT_D(J, 0, 2) = 0;
    SM_ELEMENT_D(J, 1, 0) = -g.K * per_Mv, SM_ELEMENT_D(J, 1, 1) = -(g.c * v + 1) * per_Mv - rate;
    SM_ELEMENT_D(J, 1, 2) = -per_Mv;
    SM_ELEMENT_D(J, 2, 0) = 0, SM_ELEMENT_D(J, 2, 1) = -v * (s[2] + g.beta * s[1] + g.beta), SM_ELEMENT_D(J, 2, 2) = -v;
    return 0;
}

/// A disturbance so small that its quadratic terms do not show, and the slow mode by which its growth is seen: the left
/// eigenvector of the Jacobian at steady sliding, by Eigen.
struct SmallDisturbance {
    static constexpr double probe = 1e-9;
    lanes::Groups groups;
    std::complex<double> s;
    Eigen::Vector3cd left;
    double start[3];  ///< X, w, p

    explicit SmallDisturbance(const lanes::Groups& g) : groups(g)
    {
        Eigen::Matrix3d J;
        J << 0, 1, 0, -g.K / g.M, -(g.c + 1) / g.M, -1 / g.M, 0, -g.beta, -1;
        const Eigen::EigenSolver<Eigen::Matrix3d> solver(J.transpose());
        int slow = 0;
        for (int i = 1; i < 3; ++i)
            if (solver.eigenvalues()[i].real() > solver.eigenvalues()[slow].real()) slow = i;
        s = solver.eigenvalues()[slow];
        left = solver.eigenvectors().col(slow);
        const double X = probe / std::abs(s);
        start[0] = X, start[1] = 0, start[2] = -g.K * X;
    }
    double window() const { return growth_window(s); }
    /// |l·(X, w, p)|
    double size(const double* y) const { return std::abs(left[0] * y[0] + left[1] * y[1] + left[2] * y[2]); }
};

/// Growth rate of a small disturbance over its window, per unit of time; tolerances relative to the disturbance. Not a
/// number if CVODE fails.
inline double cvode_growth(const lanes::Groups& of, double rtol)
{
    const SmallDisturbance small(of);
    CvodeSolver solver(&groups_rate);
    auto groups = of;
    double *s = NV_DATA_S(solver.y), *tolerance = NV_DATA_S(solver.tolerance);
    std::copy_n(small.start, 3, s);
    std::fill_n(tolerance, 3, rtol * SmallDisturbance::probe);
    tolerance[0] /= std::max(1.0, groups.K);
    CVodeReInit(solver.cvode, 0, solver.y);
    CVodeSVtolerances(solver.cvode, rtol, solver.tolerance);
    CVodeSetUserData(solver.cvode, &groups);
    CVodeSetJacFn(solver.cvode, &groups_jacobian);
    CVodeSetStopTime(solver.cvode, small.window());
    const double start = small.size(s);
    double t = 0;
    if (CVode(solver.cvode, small.window(), solver.y, &t, CV_NORMAL) < 0)
        return std::numeric_limits<double>::quiet_NaN();
    return std::log(small.size(s) / start) / t;
}

}  // namespace stickslip
