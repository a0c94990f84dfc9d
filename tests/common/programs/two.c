/* Two structures in one program: the midpoint of each at the end of its scene. */
#include "band.h"
#include "rod.h"

#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    double one[BAND_PARAMETERS], other[ROD_PARAMETERS], height[2];
    const double times[] = {BAND_SCENE_DURATION, ROD_SCENE_DURATION};
    band_defaults(one);
    rod_defaults(other);
    size_t first = band_workspace_size(10, 1, NULL), second = rod_workspace_size(10, 1, NULL);
    softcat_workspace room = {NULL, first > second ? first : second};
    room.memory = malloc(room.bytes);
    int code = band_midpoint(one, 10, times, 1, height, room, NULL);
    if (!code) code = rod_midpoint(other, 10, times + 1, 1, height + 1, room, NULL);
    free(room.memory);
    printf("band,rod\n%.12g,%.12g\n", height[0], height[1]);
    return code;
}
