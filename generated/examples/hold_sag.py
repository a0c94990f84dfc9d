"""Holds the sag of a glass rod by the temperature of its furnace: the loop of hold_sag.c around the FMU.

Needs FMPy and matplotlib, not softcat_sym: python hold_sag.py filament.fmu [PICTURE.png]. Prints what hold_sag.c does.
"""

import sys
import tempfile

import fmpy
import matplotlib.pyplot as plt
from fmpy.fmi3 import FMU3Slave

SECONDS, TARGET, LEAD = 120, 2e-3, 3.0  # s, m, s
COLDEST, HOTTEST, GAIN = 873.15, 1003.15, 3e5  # K, K, K/m


def furnace(sag: float, rate: float) -> float:
    """Temperature of the furnace [K] for the second to come."""
    return min(max(COLDEST + GAIN * (TARGET - sag - LEAD * rate), COLDEST), HOTTEST)


def held(path: str) -> list[tuple[int, float, float]]:
    """Time [s], temperature of the furnace [K] and sag [m] of each second."""
    description = fmpy.read_model_description(path)
    number = {variable.name: variable.valueReference for variable in description.modelVariables}
    rows, before = [], 0.0
    with tempfile.TemporaryDirectory() as folder:
        rod = FMU3Slave(
            guid=description.instantiationToken,
            modelIdentifier=description.coSimulation.modelIdentifier,
            unzipDirectory=fmpy.extract(path, folder),
            instanceName="rod",
        )
        rod.instantiate()
        rod.enterInitializationMode(stopTime=SECONDS)
        rod.exitInitializationMode()
        for second in range(1, SECONDS + 1):
            sag = -rod.getFloat64([number["midpoint"]])[0]
            kelvin = furnace(sag, sag - before)
            before = sag
            rod.setFloat64([number["temperature_ambient"]], [kelvin])
            rod.doStep(currentCommunicationPoint=second - 1, communicationStepSize=1)
            rows.append((second, kelvin, -rod.getFloat64([number["midpoint"]])[0]))
        rod.terminate()
        rod.freeInstance()
    return rows


def drawn(rows: list[tuple[int, float, float]], path: str) -> None:
    """A picture of sag and furnace."""
    time, kelvin, sag = zip(*rows, strict=True)
    figure, (above, below) = plt.subplots(2, sharex=True, figsize=(6.4, 4.4), layout="constrained")
    above.plot(time, [1e3 * one for one in sag])
    above.axhline(1e3 * TARGET, color="grey", linestyle="--")
    above.set(ylabel="sag [mm]", title="A glass rod whose sag is held by its furnace")
    below.step(time, [one - 273.15 for one in kelvin], where="pre", color="firebrick")
    below.set(xlabel="time [s]", ylabel="furnace [°C]")
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    found = held(sys.argv[1])
    print("time_s,furnace_K,sag_m")
    print("\n".join(f"{second},{kelvin:.6g},{sag:.9g}" for second, kelvin, sag in found))
    if len(sys.argv) > 2:
        drawn(found, sys.argv[2])
