/* Heights of the midpoint at even times of the scene by the solver in memory of fixed size, then
 * steps of the integrator, microseconds a step and bytes of the memory. */
#include "filament_static.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static softcat_static fixed;

int main(int count, char **words)
{
    double params[SOFTCAT_PARAMETERS];
    softcat_status status;
    int frames = count > 1 ? atoi(words[1]) : SOFTCAT_SCENE_FRAMES;
    long steps = 0;
    softcat_defaults(params);
    int code = softcat_static_begin(&fixed, params, SOFTCAT_SCENE_DURATION, 0, &status);
    clock_t began = clock();
    for (int j = 0; j < frames && !code; j++) {
        code = softcat_static_step(&fixed, SOFTCAT_SCENE_DURATION * j / (frames - 1), &status);
        steps += status.steps + status.rejected;
        printf("%.17g\n", softcat_static_midpoint(&fixed));
    }
    double seconds = (double)(clock() - began) / CLOCKS_PER_SEC;
    printf("%ld\n%.6g\n%zu\n", steps, 1e6 * seconds / (double)(steps ? steps : 1), sizeof fixed);
    return code;
}
