/* Two structures in one program: the midpoint of each at the end of its scene. */
#include "band.h"
#include "rod.h"

#include <stdio.h>

int main(void)
{
    double one[BAND_PARAMETERS], other[ROD_PARAMETERS], height[2];
    const double times[] = {BAND_SCENE_DURATION, ROD_SCENE_DURATION};
    band_defaults(one);
    rod_defaults(other);
    int code = band_midpoint(one, 10, times, 1, height, NULL);
    if (!code) code = rod_midpoint(other, 10, times + 1, 1, height + 1, NULL);
    printf("band,rod\n%.12g,%.12g\n", height[0], height[1]);
    return code;
}
