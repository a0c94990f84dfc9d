"""From measurements to constants of a law. What an import does not need is loaded when it is used."""
