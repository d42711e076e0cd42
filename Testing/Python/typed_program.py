# SPDX-License-Identifier: BSD-3-Clause
"""What a type checker has to accept, and, where a comment says so, to refuse."""
import numpy as np

import marrow

mesh = marrow.creature("biped", pose=0.3)
arrays = (np.zeros((3, 3)), np.zeros((1, 3), int))
skeleton = marrow.skeleton(mesh, finest_area=0.1, progress_bar=True)
result = marrow.transfer(skeleton, arrays, segments=[1, 2], lambda_=0.2, progress=print)
marrow.evaluate(result, result.segments).rand_error + 1.0
marrow.render(skeleton, mesh, arrays, surface_array=["MSP", None, None], view_up=(0, 0, 1))

marrow.skeleton(mesh, finest=1)  # error
marrow.measure(mesh, agd_method="exact")  # error
marrow.creature("cat")  # error
result.confidences  # error
