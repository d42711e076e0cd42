// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionLeaf.h"

#include "LabelBridge.h"
#include "SegmentationTransfer.h"
#include "SideTransfer.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkInformation.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace marrow
{
namespace
{
void SetMeanConfidence(CollectionLeaf& leaf)
{
  const WorkingSurface& working = leaf.Collected->Side.Surface.Working;
  const std::vector<int>& cells = leaf.Collected->Side.Surface.CellOfPolygon;
  double sum = 0.0;
  double total = 0.0;
  for (int t = 0; t < working.Full.NumberOfTriangles(); ++t)
  {
    const int polygon = working.CellOfFullTriangle[t];
    if (polygon >= 0)
    {
      const double area = working.Full.Area(t);
      sum += area * leaf.Confidence[cells[polygon]];
      total += area;
    }
  }
  leaf.MeanConfidence = total > 0.0 ? sum / total : 0.0;
}
}

void CollectionLeaf::AddNote(const std::string& note)
{
  this->Note += (this->Note.empty() ? "" : " ") + note;
}

std::vector<CollectionLeaf> LeavesOf(vtkDataObjectTree* tree)
{
  std::vector<CollectionLeaf> leaves;
  vtkSmartPointer<vtkDataObjectTreeIterator> iterator;
  iterator.TakeReference(tree->NewTreeIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    CollectionLeaf leaf;
    leaf.Data = iterator->GetCurrentDataObject();
    leaf.Mesh = vtkPolyData::SafeDownCast(leaf.Data);
    leaf.Name = "block " + std::to_string(iterator->GetCurrentFlatIndex());
    if (iterator->HasCurrentMetaData() &&
      iterator->GetCurrentMetaData()->Has(vtkCompositeDataSet::NAME()))
    {
      leaf.Name = iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME());
    }
    leaves.push_back(leaf);
  }
  return leaves;
}

std::vector<ShapeOfLeaf> ShapesOf(const std::vector<CollectionLeaf>& leaves)
{
  std::vector<ShapeOfLeaf> shapes;
  for (std::size_t l = 0; l < leaves.size(); ++l)
  {
    const CollectionLeaf& leaf = leaves[l];
    for (std::size_t b = 0; leaf.Mesh && b < leaf.Collected->Shapes.size(); ++b)
    {
      ShapeOfLeaf shape;
      shape.Leaf = static_cast<int>(l);
      shape.Body = static_cast<int>(b);
      // It lives as long as what it is a part of.
      shape.Shape = { leaf.Collected, leaf.Collected->Shapes[b].get() };
      if (leaf.IsSource)
      {
        const PreparedSurface& surface = leaf.Collected->Side.Surface;
        shape.Labels = LabelsOfBody(surface, surface.Bodies[b], leaf.Labels);
      }
      shapes.push_back(std::move(shape));
    }
  }
  std::stable_sort(shapes.begin(), shapes.end(),
    [](const ShapeOfLeaf& a, const ShapeOfLeaf& b)
    { return std::tie(a.Shape->Key, a.Labels) < std::tie(b.Shape->Key, b.Labels); });
  return shapes;
}

void BringToCells(const std::vector<ShapeOfLeaf>& shapes, const std::vector<SpreadLabels>& spread,
  const std::vector<std::vector<RejectedAnswer>>& rejected, std::vector<CollectionLeaf>& leaves)
{
  struct OfWorking
  {
    std::vector<int> Labels;
    std::vector<double> Confidence;
  };
  std::vector<OfWorking> ofLeaves(leaves.size());
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    CollectionLeaf& leaf = leaves[shapes[s].Leaf];
    if (leaf.IsSource)
    {
      continue;
    }
    const PreparedSurface& surface = leaf.Collected->Side.Surface;
    OfWorking& working = ofLeaves[shapes[s].Leaf];
    working.Labels.resize(surface.Working.Mesh.Triangles.size());
    working.Confidence.resize(surface.Working.Mesh.Triangles.size());
    const Body& body = surface.Bodies[shapes[s].Body];
    for (std::size_t t = 0; t < spread[s].Labels.size(); ++t)
    {
      working.Labels[body.OriginalTriangle[t]] = spread[s].Labels[t];
      working.Confidence[body.OriginalTriangle[t]] = spread[s].Confidence[t];
    }
    leaf.IsWholeAlignment = leaf.IsWholeAlignment || spread[s].IsWholeAlignment;
    if (shapes[s].Body == 0 && spread[s].Source >= 0)
    {
      leaf.Source = shapes[spread[s].Source].Leaf;
      leaf.Against = spread[s].Against;
      leaf.Rejected = rejected[s];
    }
  }
  for (std::size_t l = 0; l < leaves.size(); ++l)
  {
    CollectionLeaf& leaf = leaves[l];
    if (!leaf.Mesh)
    {
      continue;
    }
    if (leaf.IsSource)
    {
      leaf.Confidence.assign(leaf.Labels.size(), 1.0);
      leaf.MeanConfidence = 1.0;
      continue;
    }
    CellLabels ofCells =
      ToCells(leaf.Collected->Side.Surface, ofLeaves[l].Labels, ofLeaves[l].Confidence);
    leaf.Labels = std::move(ofCells.Labels);
    leaf.Confidence = std::move(ofCells.Confidence);
    SetMeanConfidence(leaf);
    for (RejectedAnswer& answer : leaf.Rejected)
    {
      const PreparedSurface& surface = leaf.Collected->Side.Surface;
      std::vector<int> labels = ofLeaves[l].Labels;
      for (std::size_t t = 0; t < answer.Labels.size(); ++t)
      {
        labels[surface.Bodies[0].OriginalTriangle[t]] = answer.Labels[t];
      }
      answer.Labels = ToCells(surface, labels, ofLeaves[l].Confidence).Labels;
    }
  }
}
}
