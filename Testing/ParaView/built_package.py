# SPDX-License-Identifier: BSD-3-Clause
"""Import this before marrow: the package of the build, and not an earlier one that was installed beside
ParaView, which comes before the PYTHONPATH."""
import os
import sys

sys.path.insert(0, os.environ["MARROW_PYTHON"])
