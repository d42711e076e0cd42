# SPDX-License-Identifier: BSD-3-Clause
"""marrow.collection and marrow.fuse: vtkCollectionTransfer and vtkSegmentationFusion."""
from __future__ import annotations

from dataclasses import dataclass
from math import isnan
from typing import Iterator, List, Mapping, Optional, Sequence, Tuple, TypedDict, Union, Unpack

from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkMultiBlockDataSet,
    vtkPolyData,
)

from ._arrays import Array, named
from ._mesh import SEGMENT_ID, Mesh, MeshLike, Segments, polydata_of, set_segments
from ._messages import Error
from ._parameters import set_parameters
from ._progress import ProgressCallback, Watch
from ._run import polydata_output, run
from .vtk import vtkCollectionTransfer, vtkSegmentationFusion


@dataclass(frozen=True, eq=False)
class Collected(Mesh):
    """A mesh of a collection with its segments: what marrow.collection gives for each."""

    name: str
    """Its name in the collection."""

    is_source: bool
    """Whether it was labelled before."""

    source: str
    """The name of the labelled mesh that counts most for it; empty for a labelled one."""

    sureness: float
    """The mean of the confidence over the area."""

    remark: str
    """What was mended and what went wrong, in words."""

    learning: float
    """The power of what was learnt from the labelled meshes by which the vote was multiplied; 0: nothing."""

    held_out_accuracy: Optional[Tuple[float, float]]
    """Of a labelled mesh whose labels were held back: accuracy of the vote, and with what was learnt."""

    @property
    def confidence(self) -> Optional[Array]:
        """(m,) float: how sure each face's segment is, from 0 to 1; None if the mesh could not be used."""
        cells = self.polydata.GetCellData()
        return named(cells, "SegmentConfidence") if cells.HasArray("SegmentConfidence") else None


class CollectionParameters(TypedDict, total=False):
    cache_folder: Optional[str]
    number_of_rejected_answers: Optional[int]
    learn_from_sources: Optional[bool]


def collection(
    meshes: Union[Mapping[str, MeshLike], Sequence[MeshLike]],
    *,
    segments: Optional[Mapping[str, Segments]] = None,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
    **parameters: Unpack[CollectionParameters],
) -> Iterator[Collected]:
    """Labels all meshes of a collection from those that are labelled; gives them in their order.

    Parameters
    ----------
    meshes
        Meshes of one kind by their names; or in a row, named "0", "1" and so on. One with the cell array
        "SegmentId" is labelled; equal numbers are equal segments on all meshes.
    segments : {name: (m,) int, or the name of a cell array}
        The segments of further labelled meshes, by name.
    cache_folder : str or None, default: None
        A folder in which what is found out about pairs of meshes is kept for another run.
    number_of_rejected_answers : int, default: 0
        How many of the answers that were not taken are given out, to be looked at, in the cell array
        "RejectedSegmentId" of each mesh's polydata.
    learn_from_sources : bool, default: True
        With three labelled meshes or more, learn from them too, as far as that does well on each of them when
        its labels are held back. Where Marrow was built without dlib nothing is learnt.
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    iterator of Collected
        The meshes in their order, all labelled; see also the class vtkCollectionTransfer.

    Raises
    ------
    Error
        If no mesh is labelled.

    Warns
    -----
    MarrowWarning
        For each mesh that cannot be used, which comes back as it is.

    Examples
    --------
    >>> import marrow
    >>> herd = {str(seed): marrow.creature("biped", seed=seed, pose=0.5) for seed in (1, 2, 3)}
    >>> bare = {name: (mesh.points, mesh.faces) for name, mesh in herd.items()}
    >>> for mesh in marrow.collection(bare, segments={"1": herd["1"].segments}):
    ...     print(mesh.name, sorted(set(mesh.segments.tolist())))
    1 [0, 1, 2, 3, 4, 5, 6]
    2 [0, 1, 2, 3, 4, 5, 6]
    3 [0, 1, 2, 3, 4, 5, 6]
    """
    if not isinstance(meshes, Mapping):
        meshes = {str(index): mesh for index, mesh in enumerate(meshes)}
    given = dict(segments or {})
    unknown = [name for name in given if name not in meshes]
    if unknown:
        raise Error(f"segments are given for {', '.join(map(repr, unknown))}, but no such mesh.")
    algorithm = vtkCollectionTransfer()
    set_parameters(algorithm, collection, CollectionParameters, parameters)
    blocks = vtkMultiBlockDataSet()
    for index, (name, mesh) in enumerate(meshes.items()):
        polydata = polydata_of(mesh)
        if name in given:
            array = set_segments(polydata, given[name])
            if array != SEGMENT_ID:
                renamed = polydata.GetCellData().GetArray(array)
                if renamed is None:
                    raise Error(f"{name}: the mesh has no cell array {array!r} of segments.")
                copy = renamed.NewInstance()
                copy.DeepCopy(renamed)
                copy.SetName(SEGMENT_ID)
                polydata.GetCellData().AddArray(copy)
        blocks.SetBlock(index, polydata)
        blocks.GetMetaData(index).Set(vtkCompositeDataSet.NAME(), name)
    algorithm.SetInputDataObject(blocks)
    with Watch("collection", progress, progress_bar) as watch:
        run(algorithm, "collection", watch)
    return iter(_collected(algorithm))


def _collected(algorithm: vtkCollectionTransfer) -> List[Collected]:
    blocks = algorithm.GetOutputDataObject(0)
    table = algorithm.GetOutputDataObject(1)
    result = []
    for row in range(table.GetNumberOfRows()):
        polydata = vtkPolyData()
        polydata.ShallowCopy(blocks.GetBlock(row))
        held_out = (
            table.GetValueByName(row, "HeldOutAccuracy").ToDouble(),
            table.GetValueByName(row, "HeldOutAccuracyLearnt").ToDouble(),
        )
        result.append(
            Collected(
                polydata,
                table.GetValueByName(row, "Block").ToString(),
                bool(table.GetValueByName(row, "IsSource").ToInt()),
                table.GetValueByName(row, "Source").ToString(),
                table.GetValueByName(row, "Confidence").ToDouble(),
                table.GetValueByName(row, "Note").ToString(),
                table.GetValueByName(row, "Learning").ToDouble(),
                None if isnan(held_out[0]) else held_out,
            )
        )
    return result


@dataclass(frozen=True, eq=False)
class Fusion(Mesh):
    """A mesh with one labelling made of several: what marrow.fuse returns."""

    @property
    def confidence(self) -> Array:
        """(m,) float: how sure each face's segment is, from 0 to 1."""
        return named(self.polydata.GetCellData(), "SegmentConfidence")

    @property
    def disagreement(self) -> Array:
        """(m,) float: the chance that two votes on the face differ; 0 where all agree."""
        return named(self.polydata.GetCellData(), "SegmentDisagreement")

    @property
    def shares(self) -> Tuple[Array, Array]:
        """(s,) int, (m, s) float: the segments, and the share of the votes of each on each face."""
        shares = named(self.polydata.GetCellData(), "SegmentShares")
        ids = named(self.polydata.GetFieldData(), "SegmentShareId")
        return ids, shares.reshape(len(shares), len(ids))

    @property
    def weights(self) -> Array:
        """(k,) float: how much each labelling counts, the most 1."""
        return named(self.polydata.GetFieldData(), "LabellingWeight")


class FusionParameters(TypedDict, total=False):
    estimate_trust: Optional[bool]


def fuse(
    labellings: Sequence[MeshLike],
    *,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
    **parameters: Unpack[FusionParameters],
) -> Fusion:
    """Makes one labelling of a mesh out of several.

    Parameters
    ----------
    labellings
        The same mesh with different segments, its cell array "SegmentId": the results of marrow.transfer
        from several sources, or of several people.
    estimate_trust : bool, default: False
        Each labelling counts by how often it is right, as estimated from all of them.
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    Fusion
        The mesh with the segments, how sure they are and the votes; see also the class
        vtkSegmentationFusion.

    Raises
    ------
    Error
        If the labellings are not of one mesh.

    Examples
    --------
    >>> import marrow
    >>> target = marrow.creature("biped")
    >>> sources = [marrow.creature("biped", seed=seed, pose=0.4) for seed in (2, 3, 4)]
    >>> fused = marrow.fuse([marrow.transfer(source, target) for source in sources])
    >>> marrow.evaluate(fused, target).label_accuracy > 0.9
    True
    """
    if not labellings:
        raise Error("fuse: there are no labellings; give at least one.")
    algorithm = vtkSegmentationFusion()
    set_parameters(algorithm, fuse, FusionParameters, parameters)
    for labelling in labellings:
        algorithm.AddInputDataObject(0, polydata_of(labelling))
    with Watch("fuse", progress, progress_bar) as watch:
        run(algorithm, "fuse", watch)
    return Fusion(polydata_output(algorithm))
