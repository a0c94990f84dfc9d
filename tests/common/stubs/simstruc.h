/* Of Simulink's simstruc.h the types of what an S-function here calls, to compile it without MATLAB. */
#ifndef STUB_SIMSTRUC_H
#define STUB_SIMSTRUC_H
typedef struct SimStruct SimStruct;
typedef struct mxArray mxArray;
typedef int int_T;
void ssSetNumSFcnParams(SimStruct *, int), ssSetInputPortWidth(SimStruct *, int, int);
int ssGetNumSFcnParams(SimStruct *), ssGetSFcnParamsCount(SimStruct *);
int ssSetNumInputPorts(SimStruct *, int), ssSetNumOutputPorts(SimStruct *, int);
void ssSetInputPortRequiredContiguous(SimStruct *, int, int), ssSetInputPortDirectFeedThrough(SimStruct *, int, int);
void ssSetOutputPortWidth(SimStruct *, int, int), ssSetNumSampleTimes(SimStruct *, int), ssSetNumPWork(SimStruct *, int);
void ssSetSampleTime(SimStruct *, int, double), ssSetOffsetTime(SimStruct *, int, double);
double mxGetScalar(const mxArray *), ssGetTFinal(SimStruct *), ssGetT(SimStruct *), ssGetSampleTime(SimStruct *, int);
const mxArray *ssGetSFcnParam(SimStruct *, int);
void ssSetErrorStatus(SimStruct *, const char *), ssSetPWorkValue(SimStruct *, int, void *);
void *ssGetPWorkValue(SimStruct *, int);
double *ssGetOutputPortRealSignal(SimStruct *, int);
const double *ssGetInputPortRealSignal(SimStruct *, int);
#endif
