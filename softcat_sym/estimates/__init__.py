"""How large each effect will be, before a run: scaling, quasi-static sag, free vibration, forecast, regime."""
