"""A scene as one page for a browser, in which its compiled solver runs."""
