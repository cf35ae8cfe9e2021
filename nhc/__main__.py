"""``python -m nhc`` is ``nhc``."""

import sys

from nhc.cli import main

if __name__ == "__main__":
    sys.exit(main())
