"""Films of falling filaments: read, corrected, held against their scene."""
