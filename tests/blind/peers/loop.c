/* The loop that parameter_fit.py fits: one mass with Coulomb and viscous friction under a sampled PD law. Signs and timing as
 * in the interface of records. p: inertia, viscous, coulomb, encoder offset, load, gravity amplitude, dead time [s]. */
#include <math.h>

enum { most_late = 64 };

struct law { double tick, k_p, k_v, filtered, limit, gain, phase; };

/* Mean square of `measured` less the simulated readings, one reading every `every` ticks. */
double misfit(const struct law* law, const double* p, const double* reference, const double* rate, const double* measured,
              int rows, int every)
{
    const double m = p[0], late = fmin(p[6] / law->tick, most_late - 2);
    const int whole = (int)late;
    const double part = late - whole;
    double q = reference[0] - p[3], v = 0, estimate = 0, last = reference[0], past[most_late] = {0}, sum = 0;
    for (int k = 0; k < rows * every; ++k) {
        const double y = q + p[3];
        estimate += law->filtered * ((y - last) / law->tick - estimate);
        last = y;
        double command = law->k_p * (reference[k] - y) + law->k_v * (rate[k] - estimate);
        command = fmax(-law->limit, fmin(law->limit, command));
        past[k % most_late] = law->gain * command;
        const double u = (1 - part) * past[(k + most_late - whole) % most_late] +
                         part * past[(k + 2 * most_late - whole - 1) % most_late];
        if (k % every == 0) sum += (measured[k / every] - y) * (measured[k / every] - y);
        /* four steps a tick; friction takes what it can of the velocity, and no more */
        for (int i = 0; i < 4; ++i) {
            const double h = law->tick / 4, free = v + h / m * (u + p[4] - p[5] * sin(q + law->phase) - p[1] * v);
            const double slowed = copysign(fmax(0, fabs(free) - h / m * p[2]), free);
            q += 0.5 * h * (v + slowed);
            v = slowed;
        }
    }
    return sum / rows;
}
