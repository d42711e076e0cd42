# SPDX-License-Identifier: BSD-3-Clause
"""Skeleton-driven segmentation transfer; the VTK classes are in marrow.vtk."""
