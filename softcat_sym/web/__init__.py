"""A scene as one page that solves it in the browser."""
