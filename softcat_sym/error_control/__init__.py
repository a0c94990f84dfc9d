"""How accurate an answer is, found on the run itself, and what makes it as accurate as was asked."""
