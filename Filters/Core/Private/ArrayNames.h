// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ArrayNames_h
#define marrow_ArrayNames_h

/// The names of the data contract (Documentation/data-contract.md), written down once.
namespace marrow::names
{
// On mesh points
inline constexpr const char* AGD = "AGD";
inline constexpr const char* MSP = "MSP";
inline constexpr const char* MSPCenter = "MSPCenter";
inline constexpr const char* MSPNormal = "MSPNormal";
inline constexpr const char* MSPGradient = "MSPGradient";
inline constexpr const char* MSPValid = "MSPValid";
inline constexpr const char* DihedralAngle = "DihedralAngle";
inline constexpr const char* SkeletonNodeId = "SkeletonNodeId";

// On skeleton points (AGD and MSP too)
inline constexpr const char* NodeType = "NodeType";
inline constexpr const char* Radius = "Radius";
inline constexpr const char* VertexCount = "VertexCount";
inline constexpr const char* CorrespondenceId = "CorrespondenceId";

// On skeleton cells
inline constexpr const char* BranchId = "BranchId";
inline constexpr const char* BranchLength = "BranchLength";
inline constexpr const char* BranchCorrespondenceId = "BranchCorrespondenceId";
inline constexpr const char* BranchCorrespondenceOrder = "BranchCorrespondenceOrder";
inline constexpr const char* BranchCorrespondenceReversed = "BranchCorrespondenceReversed";

// On the skeleton as a whole (field data), about the mesh that it belongs to
inline constexpr const char* MeshDiagonal = "MeshDiagonal";
inline constexpr const char* MeshMaximumMSP = "MeshMaximumMSP";

// On two skeletons that were matched (field data)
inline constexpr const char* CorrespondenceConfidence = "CorrespondenceConfidence";

// On the points of hints
inline constexpr const char* Forbidden = "Forbidden";

// On mesh cells
inline constexpr const char* SegmentId = "SegmentId";
inline constexpr const char* SegmentConfidence = "SegmentConfidence";
inline constexpr const char* SegmentDisagreement = "SegmentDisagreement";
inline constexpr const char* SegmentShares = "SegmentShares";
inline constexpr const char* RejectedSegmentId = "RejectedSegmentId";

// On the cells of a mesh that was cut along its segments: as VTK calls it
inline constexpr const char* OriginalCellIds = "vtkOriginalCellIds";

// On a mesh that was labelled as a whole (field data)
inline constexpr const char* MatchingCost = "MatchingCost";
inline constexpr const char* MatchingEvidence = "MatchingEvidence";
inline constexpr const char* MatchingConfidence = "MatchingConfidence";
inline constexpr const char* MatchedBy = "MatchedBy";
inline constexpr const char* SegmentShareId = "SegmentShareId";
inline constexpr const char* RejectedAgainst = "RejectedAgainst";
inline constexpr const char* RejectedDifference = "RejectedDifference";
inline constexpr const char* LabellingWeight = "LabellingWeight";

// On the cells of a mesh that was read from a file with such parts
inline constexpr const char* GroupId = "GroupId";
inline constexpr const char* ObjectId = "ObjectId";
inline constexpr const char* MaterialId = "MaterialId";

// On a mesh as a whole (field data): what each number stands for
inline constexpr const char* SegmentName = "SegmentName";
inline constexpr const char* GroupName = "GroupName";
inline constexpr const char* ObjectName = "ObjectName";
inline constexpr const char* MaterialName = "MaterialName";

// On the working surface's cells, and on the cells and points of the mesh that it was made of
inline constexpr const char* BodyId = "BodyId";
inline constexpr const char* WorkingTriangleId = "WorkingTriangleId";
inline constexpr const char* WorkingVertexId = "WorkingVertexId";

// On both as a whole (field data), beside the counts of SurfaceReport
inline constexpr const char* WorkingSurfaceNote = "WorkingSurfaceNote";

// On boundary cells
inline constexpr const char* BoundaryId = "BoundaryId";
}

#endif
