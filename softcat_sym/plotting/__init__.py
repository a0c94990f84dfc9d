"""Pictures, tables and terminal output of runs and studies. Matplotlib and rich are loaded when they are used."""
