"""``python -m softcat_sym`` is the ``softcat`` command."""

from softcat_sym.cli import main

if __name__ == "__main__":
    main()
