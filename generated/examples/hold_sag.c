/* Holds the sag of a glass rod by the temperature of its furnace: a loop of one second around the
 * solver in memory of fixed size, as a microcontroller would run it. C99.
 *
 * Writes time, temperature of the furnace and sag as CSV. The controller sees the sag alone; it
 * looks some seconds ahead, since the rod follows the furnace late, and what has sagged stays. */
#include "filament_static.h"

#include <math.h>
#include <stdio.h>

enum { SECONDS = 120, MAX_STEPS = 2000 }; /* of the integrator, in each second: a bound on its time */

static const double target = 2e-3, lead = 3.0;           /* [m], [s] */
static const double coldest = 873.15, hottest = 1003.15; /* [K] */
static const double gain = 3e5;                          /* [K/m] */

static softcat_static rod; /* all memory that there is */

static double furnace(double sag, double rate)
{
    double wanted = coldest + gain * (target - sag - lead * rate);
    return fmin(fmax(wanted, coldest), hottest);
}

int main(void)
{
    double params[SOFTCAT_PARAMETERS], before = 0.0;
    softcat_status status;
    softcat_defaults(params);
    int code = softcat_static_begin(&rod, params, SECONDS, MAX_STEPS, &status);
    printf("time_s,furnace_K,sag_m\n");
    for (int second = 1; second <= SECONDS && !code; second++) {
        double sag = -softcat_static_midpoint(&rod), *kelvin = params + SOFTCAT_P_TEMPERATURE_AMBIENT;
        *kelvin = furnace(sag, sag - before);
        before = sag;
        code = softcat_static_change(&rod, params, &status);
        if (!code) code = softcat_static_step(&rod, second, &status);
        printf("%d,%.6g,%.9g\n", second, *kelvin, -softcat_static_midpoint(&rod));
    }
    if (code) fprintf(stderr, "%s, at t = %g s\n", softcat_explain(code), status.reached);
    return code != SOFTCAT_SOLVED;
}
