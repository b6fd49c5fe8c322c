"""`python -m slowflow`: the command line."""

import sys

from slowflow.app.cli import main

if __name__ == "__main__":
    sys.exit(main())
