"""Pictures, tables and terminal output of runs and studies. Matplotlib and rich are loaded when they are used."""

from softcat_sym.drawing import plot as plot

DRAWN_IN = {
    "Run": "run", "Fit": "fit", "ClosedForm": "fit", "Posterior": "posterior",
    "Card": "card", "Sweep": "sweep", "PhaseDiagram": "phase",
    "Comparison": "compare", "TheoryEnd": "theory_end", "Pricing": "effect_importance", "WorkPrecision": "accuracy",
    "Validation": "validate", "Result": "validate", "FlowCurveFit": "flow_curve", "Experiment": "design",
    "CriticalSpan": "design", "BridgeTable": "design", "RheometerMaterial": "material",
    "Track": "track", "PillarContour": "track",
}  # fmt: skip
"""Module in which the pictures and the report of each result are registered."""
