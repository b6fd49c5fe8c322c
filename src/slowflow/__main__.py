"""`python -m slowflow`: the command line."""

import sys

from slowflow.cli import main

if __name__ == "__main__":
    sys.exit(main())
