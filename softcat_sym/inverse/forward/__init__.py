"""What a camera sees of a filament, for any values of what is free, with derivatives."""
