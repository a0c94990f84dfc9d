"""Independent truth: closed forms and finite elements, to judge the filament by."""
