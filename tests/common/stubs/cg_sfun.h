/* What an S-function includes last: it calls the functions that Simulink would. */
void called_by_simulink(SimStruct *);
void called_by_simulink(SimStruct *S)
{
    mdlInitializeSizes(S), mdlInitializeSampleTimes(S), mdlStart(S), mdlOutputs(S, 0), mdlUpdate(S, 0), mdlTerminate(S);
}
