/* A filament that is stepped from outside: a controller, a co-simulation, a real-time loop.
 *
 * All of it lives in memory of the caller's; nothing is allocated. Steps are those of a solve: the
 * integrator goes as far as its tolerance allows, beyond the time that is asked for, and the state
 * there is its dense output. So the times at which a session is looked at change nothing. Only a
 * change of parameters begins anew from where the session is. */
#ifndef SOFTCAT_SESSION_H
#define SOFTCAT_SESSION_H

#include "softcat_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct softcat_session softcat_session;

/* Bytes of its memory; settings or NULL. 0 if cells or fibres are out of range. */
size_t softcat_session_size(const softcat_structure *, int cells, const softcat_settings *);

/* Begin at rest at t = 0, as softcat_structure_solve does; NULL if *status says why not.
 *
 * params and settings (which may be NULL) are copied, but not the arrays that settings point to.
 * last [s]: where the last step shall end, at which a solve would; 0: none is known. max_steps of
 * the settings bounds each call of softcat_session_step; 0: 100000. */
softcat_session *softcat_session_begin(const softcat_structure *, const double *params, int cells,
                                       const softcat_settings *, double last, softcat_workspace,
                                       softcat_status *);

/* Go on to a time [s], not before that of the session. 0 or a code; status (or NULL) then says up to
 * which time the state is known, and the session stays there. After SOFTCAT_STEP_LIMIT and
 * SOFTCAT_STOPPED it may go on. */
int softcat_session_step(softcat_session *, double time, softcat_status *);

/* Other parameters from now on, in place of all; those that are units of the unknowns (rest length,
 * time scale) and times of a path cannot change. 0 or a code; *which (or NULL): the number of the
 * parameter that is wrong. Algebraic unknowns may jump. */
int softcat_session_change(softcat_session *, const double *params, int *which, softcat_status *);

double softcat_session_time(const softcat_session *);
const double *softcat_session_parameters(const softcat_session *);
double softcat_session_midpoint(const softcat_session *);

/* Positions of all nodes, as softcat_results has them: [softcat_structure_row]. */
void softcat_session_positions(const softcat_session *, double *out);

/* Unknowns [sites * slots] at the time, with the filament whose they are. */
const double *softcat_session_state(const softcat_session *, softcat_filament *, double *model_time);

/* Work of each power since t = 0, J per m^2 of the undeformed section: [model->powers]. */
void softcat_session_work(const softcat_session *, double *out);

/* All that changes while a session is stepped, in doubles, to come back to: what follows is the same
 * to the last digit, also in another session of the same structure, cells and settings.
 * softcat_session_load: 0, or SOFTCAT_ARGUMENT if that is no such thing. */
size_t softcat_session_count(const softcat_session *);
void softcat_session_save(const softcat_session *, double *to);
int softcat_session_load(softcat_session *, const double *from, size_t count);

#ifdef __cplusplus
}
#endif
#endif
