"""Many runs that differ in some values: a table of parameters, all cores, one result."""
