#include "analysis/simulation/solvers/stepper.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <array>

namespace stickslip {
namespace {

struct Free {
    void operator()(N_Vector v) const { N_VDestroy(v); }
    void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
    void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
    void operator()(void* cvode) const { CVodeFree(&cvode); }
};
using Vector = std::unique_ptr<_generic_N_Vector, Free>;
using Matrix = std::unique_ptr<_generic_SUNMatrix, Free>;
using LinearSolver = std::unique_ptr<_generic_SUNLinearSolver, Free>;

struct Context {
    SUNContext value = nullptr;
    Context()
    {
        // a failure is reported as a value; CVODE's own messages on stderr would say it twice
#if SUNDIALS_VERSION_MAJOR >= 7
        SUNContext_Create(SUN_COMM_NULL, &value);
        SUNContext_ClearErrHandlers(value);
#else
        SUNContext_Create(nullptr, &value);
#endif
    }
    ~Context()
    {
        SUNContext_Free(&value);
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

FlowVector copy_of(N_Vector v)
{
    return Eigen::Map<const Eigen::VectorXd>(N_VGetArrayPointer(v), N_VGetLength(v));
}

class CvodeStepper final : public Stepper {
  public:
    explicit CvodeStepper(double rtol) : rtol_(rtol) {}

    void start(const Flow& flow, double t, const FlowVector& y, const Events& events) override
    {
        flow_ = &flow;
        events_ = &events;
        t_ = t;
        state_ = y;
        if (!cvode_ || n_ != flow.size() || event_count_ != events.count) create(flow.size(), events.count);
        Eigen::Map<Eigen::VectorXd>(N_VGetArrayPointer(y_.get()), n_) = y;
        Eigen::Map<Eigen::VectorXd>(N_VGetArrayPointer(tolerance_.get()), n_) = rtol_ * flow.scale();
        CVodeReInit(cvode_.get(), t, y_.get());
        CVodeSVtolerances(cvode_.get(), rtol_, tolerance_.get());
    }

    StepReport step(double t_end) override
    {
        CVodeSetStopTime(cvode_.get(), t_end);
        const int flag = CVode(cvode_.get(), t_end, y_.get(), &t_, CV_ONE_STEP);
        state_ = copy_of(y_.get());
        if (flag < 0 || !state_.allFinite()) return {StepEnd::failure};
        if (flag == CV_TSTOP_RETURN) return {StepEnd::time};
        if (flag != CV_ROOT_RETURN) return {StepEnd::step};
        std::array<int, max_events> found{};
        CVodeGetRootInfo(cvode_.get(), found.data());
        for (int i = 0; i < event_count_; ++i)
            if (found[i] != 0) return {StepEnd::event, i, found[i]};
        return {StepEnd::step};
    }

    double time() const override { return t_; }
    const FlowVector& state() const override { return state_; }

    FlowVector at(double t) const override
    {
        CVodeGetDky(cvode_.get(), t, 0, work_.get());
        return copy_of(work_.get());
    }

  private:
    void create(int n, int event_count)
    {
        n_ = n;
        event_count_ = event_count;
        cvode_.reset();
        y_.reset(N_VNew_Serial(n, context_.value));
        work_.reset(N_VNew_Serial(n, context_.value));
        tolerance_.reset(N_VNew_Serial(n, context_.value));
        matrix_.reset(SUNDenseMatrix(n, n, context_.value));
        linear_.reset(SUNLinSol_Dense(y_.get(), matrix_.get(), context_.value));
        cvode_.reset(CVodeCreate(CV_BDF, context_.value));
        CVodeInit(cvode_.get(), &rate, 0, y_.get());
#if SUNDIALS_VERSION_MAJOR < 7  // from there on the context has the handlers
        CVodeSetErrHandlerFn(cvode_.get(), [](int, const char*, const char*, char*, void*){}, nullptr);
#endif
        CVodeSetUserData(cvode_.get(), this);
        CVodeSetLinearSolver(cvode_.get(), linear_.get(), matrix_.get());
        CVodeSetJacFn(cvode_.get(), &jacobian);
        CVodeSetMaxNumSteps(cvode_.get(), 1'000'000);
        if (event_count > 0) CVodeRootInit(cvode_.get(), event_count, &roots);
        CVodeSetNoInactiveRootWarn(cvode_.get());
    }

    static CvodeStepper& self(void* user)
    {
        return *static_cast<CvodeStepper*>(user);
    }

    static int rate(double, N_Vector y, N_Vector ydot, void* user)
    {
        FlowVector out;
        self(user).flow_->rate(copy_of(y), out);
        Eigen::Map<Eigen::VectorXd>(N_VGetArrayPointer(ydot), out.size()) = out;
        return out.allFinite() ? 0 : 1;  // 1: recoverable, CVODE tries a shorter step
    }

    static int jacobian(double, N_Vector y, N_Vector, SUNMatrix J, void* user, N_Vector, N_Vector, N_Vector)
    {
        FlowMatrix out;
        self(user).flow_->jacobian(copy_of(y), out);
        Eigen::Map<Eigen::MatrixXd>(SUNDenseMatrix_Data(J), out.rows(), out.cols()) = out;
        return out.allFinite() ? 0 : 1;
    }

    static int roots(double, N_Vector y, double* values, void* user)
    {
        self(user).events_->values(copy_of(y), values);
        return 0;
    }

    double rtol_;
    int n_ = 0, event_count_ = 0;
    const Flow* flow_ = nullptr;
    const Events* events_ = nullptr;
    double t_ = 0;
    FlowVector state_;
    Context context_;
    Vector y_, work_, tolerance_;
    Matrix matrix_;
    LinearSolver linear_;
    std::unique_ptr<void, Free> cvode_;
};

}  // namespace

std::unique_ptr<Stepper> cvode_stepper(double rtol)
{
    return std::make_unique<CvodeStepper>(rtol);
}

}  // namespace stickslip
