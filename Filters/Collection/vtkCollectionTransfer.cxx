// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCollectionTransfer.h"

#include "AnswerVote.h"
#include "ArrayNames.h"
#include "CollectedMeshes.h"
#include "CollectedPairs.h"
#include "FilterSupport.h"
#include "LabelBridge.h"
#include "LabelSpread.h"
#include "MeshBridge.h"
#include "PairSelection.h"
#include "RejectedAnswers.h"
#include "SegmentationTransfer.h"
#include "SharedPairs.h"
#include "SideTransfer.h"
#ifdef MARROW_HAS_DLIB
#include "SourceLearning.h"
#endif

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkCollectionTransfer);

namespace
{
/// Of the progress, where several processes share the pairs.
constexpr double OfSharedPairs = 0.6;

/// A leaf of the tree, and what comes of it.
struct Leaf
{
  vtkDataObject* Data = nullptr;
  vtkPolyData* Mesh = nullptr; ///< null if it is none, or cannot be used
  std::string Name;
  std::vector<int> Labels; ///< per cell; of a target those found
  bool IsSource = false;
  std::vector<double> Confidence; ///< per cell
  std::shared_ptr<const marrow::CollectedMesh> Collected;
  int Source = -1; ///< the leaf that counts most for it
  double Against = 0.0;
  double Learning = 0.0;
  double HeldOutAccuracy = std::numeric_limits<double>::quiet_NaN();
  double HeldOutAccuracyLearnt = std::numeric_limits<double>::quiet_NaN();
  double MeanConfidence = 0.0;
  bool IsWholeAlignment = false;
  std::vector<marrow::RejectedAnswer> Rejected; ///< Labels per cell
  std::string Note;
};

/// A body of a leaf, as one shape of the collection.
struct ShapeOfLeaf
{
  int Leaf = 0;
  int Body = 0;
  std::shared_ptr<const marrow::CollectionShape> Shape;
  std::vector<int> Labels; ///< per triangle; empty: not known
};

std::vector<Leaf> LeavesOf(vtkDataObjectTree* tree)
{
  std::vector<Leaf> leaves;
  vtkSmartPointer<vtkDataObjectTreeIterator> iterator;
  iterator.TakeReference(tree->NewTreeIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    Leaf leaf;
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

void AddNote(Leaf& leaf, const std::string& note)
{
  leaf.Note += (leaf.Note.empty() ? "" : " ") + note;
}

/// The bodies of all leaves, in an order that their contents alone give.
std::vector<ShapeOfLeaf> ShapesOf(const std::vector<Leaf>& leaves)
{
  std::vector<ShapeOfLeaf> shapes;
  for (std::size_t l = 0; l < leaves.size(); ++l)
  {
    const Leaf& leaf = leaves[l];
    for (std::size_t b = 0; leaf.Mesh && b < leaf.Collected->Shapes.size(); ++b)
    {
      ShapeOfLeaf shape;
      shape.Leaf = static_cast<int>(l);
      shape.Body = static_cast<int>(b);
      // It lives as long as what it is a part of.
      shape.Shape = { leaf.Collected, leaf.Collected->Shapes[b].get() };
      if (leaf.IsSource)
      {
        const marrow::PreparedSurface& surface = leaf.Collected->Side.Surface;
        shape.Labels = marrow::LabelsOfBody(surface, surface.Bodies[b], leaf.Labels);
      }
      shapes.push_back(std::move(shape));
    }
  }
  std::stable_sort(shapes.begin(), shapes.end(),
    [](const ShapeOfLeaf& a, const ShapeOfLeaf& b)
    { return std::tie(a.Shape->Key, a.Labels) < std::tie(b.Shape->Key, b.Labels); });
  return shapes;
}

/// Multiplies the shares of the targets by what the leaves that are held out teach.
void Learn([[maybe_unused]] const marrow::CollectionGraph& graph,
  [[maybe_unused]] const std::vector<int>& heldOut,
  [[maybe_unused]] std::vector<marrow::LabelShares>& shares,
  [[maybe_unused]] std::vector<Leaf>& leaves, [[maybe_unused]] const marrow::Progress& progress)
{
#ifdef MARROW_HAS_DLIB
  const marrow::SourceLessons lessons = marrow::LearnFromSources(graph, heldOut, shares, progress);
  for (Leaf& leaf : leaves)
  {
    leaf.Learning = leaf.Mesh && !leaf.IsSource ? lessons.Exponent : 0.0;
  }
  for (const marrow::HeldOutAccuracy& accuracy : lessons.HeldOut)
  {
    leaves[accuracy.Mesh].HeldOutAccuracy = accuracy.ByVote;
    leaves[accuracy.Mesh].HeldOutAccuracyLearnt = accuracy.Learnt;
  }
#endif
}

/// The pairs that are worth matching; and, if it `learns`, the leaves whose labels are to be held back.
std::vector<std::pair<int, int>> SelectPairsOf(
  const std::vector<ShapeOfLeaf>& shapes, bool learns, std::vector<int>& heldOut)
{
  std::vector<std::vector<double>> sketches;
  std::vector<int> leafOfShape;
  std::vector<bool> isSource;
  for (const ShapeOfLeaf& shape : shapes)
  {
    sketches.push_back(marrow::SketchOf(shape.Shape->Fine.Skeleton));
    leafOfShape.push_back(shape.Leaf);
    isSource.push_back(!shape.Labels.empty());
  }
  heldOut = learns ? marrow::MeshesToHoldOut(leafOfShape, isSource) : std::vector<int>();
  return marrow::SelectPairs(
    sketches, leafOfShape, isSource, marrow::ShapesToTell(leafOfShape, isSource, heldOut));
}

std::vector<marrow::CollectionMember> MembersOf(
  const std::vector<Leaf>& leaves, const std::vector<int>& leafOfMesh)
{
  std::vector<marrow::CollectionMember> members;
  for (const int l : leafOfMesh)
  {
    members.push_back({ leaves[l].Mesh, leaves[l].IsSource });
  }
  return members;
}

/// The maps by which shapes hear their tellers and that are not carried out yet. `leafOfMesh` ascends.
std::vector<marrow::WantedMaps> MapsWantedBy(const marrow::CollectionGraph& graph,
  const std::vector<ShapeOfLeaf>& shapes, const std::vector<int>& leafOfMesh)
{
  const auto endOf = [&](int shape)
  {
    const auto member = std::lower_bound(leafOfMesh.begin(), leafOfMesh.end(), shapes[shape].Leaf);
    return std::make_pair(static_cast<int>(member - leafOfMesh.begin()), shapes[shape].Body);
  };
  std::vector<marrow::WantedMaps> ofLinks(graph.GetLinks().size());
  for (int s = 0; s < graph.NumberOfShapes(); ++s)
  {
    for (const marrow::Teller& teller : graph.GetTellers(s))
    {
      const marrow::CollectionLink& link = graph.GetLinks()[teller.Link];
      if (!link.Pair->IsCarried(teller.Side, link.Answer))
      {
        marrow::WantedMaps& wanted = ofLinks[teller.Link];
        wanted.Ends = { endOf(link.Shapes[0]), endOf(link.Shapes[1]) };
        wanted.OfAnswers.emplace_back(teller.Side, link.Answer);
      }
    }
  }
  ofLinks.erase(std::remove_if(ofLinks.begin(), ofLinks.end(),
                  [](const marrow::WantedMaps& wanted) { return wanted.OfAnswers.empty(); }),
    ofLinks.end());
  return ofLinks;
}

void SetMeanConfidence(Leaf& leaf)
{
  const marrow::WorkingSurface& working = leaf.Collected->Side.Surface.Working;
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

/// Brings what the bodies got to the cells of their leaves; `rejected` are the answers that the largest bodies
/// did not take.
void Collect(const std::vector<ShapeOfLeaf>& shapes,
  const std::vector<marrow::SpreadLabels>& spread,
  const std::vector<std::vector<marrow::RejectedAnswer>>& rejected, std::vector<Leaf>& leaves)
{
  struct OfWorking
  {
    std::vector<int> Labels;
    std::vector<double> Confidence;
    double Area = 0.0;
  };
  std::vector<OfWorking> ofLeaves(leaves.size());
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    Leaf& leaf = leaves[shapes[s].Leaf];
    if (leaf.IsSource)
    {
      continue;
    }
    const marrow::PreparedSurface& surface = leaf.Collected->Side.Surface;
    OfWorking& working = ofLeaves[shapes[s].Leaf];
    working.Labels.resize(surface.Working.Mesh.Triangles.size());
    working.Confidence.resize(surface.Working.Mesh.Triangles.size());
    const marrow::Body& body = surface.Bodies[shapes[s].Body];
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
    Leaf& leaf = leaves[l];
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
    marrow::CellLabels ofCells =
      marrow::ToCells(leaf.Collected->Side.Surface, ofLeaves[l].Labels, ofLeaves[l].Confidence);
    leaf.Labels = std::move(ofCells.Labels);
    leaf.Confidence = std::move(ofCells.Confidence);
    SetMeanConfidence(leaf);
    for (marrow::RejectedAnswer& answer : leaf.Rejected)
    {
      const marrow::PreparedSurface& surface = leaf.Collected->Side.Surface;
      std::vector<int> labels = ofLeaves[l].Labels;
      for (std::size_t t = 0; t < answer.Labels.size(); ++t)
      {
        labels[surface.Bodies[0].OriginalTriangle[t]] = answer.Labels[t];
      }
      answer.Labels = marrow::ToCells(surface, labels, ofLeaves[l].Confidence).Labels;
    }
  }
}

/// The answers that were not taken, a component of the arrays for each.
void WriteRejected(const std::vector<marrow::RejectedAnswer>& rejected, vtkPolyData* output)
{
  const int size = static_cast<int>(rejected.size());
  vtkNew<vtkIntArray> labels;
  labels->SetName(marrow::names::RejectedSegmentId);
  labels->SetNumberOfComponents(size);
  labels->SetNumberOfTuples(output->GetNumberOfCells());
  vtkNew<vtkDoubleArray> against;
  against->SetName(marrow::names::RejectedAgainst);
  vtkNew<vtkDoubleArray> difference;
  difference->SetName(marrow::names::RejectedDifference);
  for (int i = 0; i < size; ++i)
  {
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      labels->SetTypedComponent(cell, i, rejected[i].Labels[cell]);
    }
    against->InsertNextValue(rejected[i].Against);
    difference->InsertNextValue(rejected[i].Difference);
  }
  output->GetCellData()->AddArray(labels);
  output->GetFieldData()->AddArray(against);
  output->GetFieldData()->AddArray(difference);
}

vtkSmartPointer<vtkPolyData> LabelledMesh(const Leaf& leaf, vtkAbstractArray* segmentNames)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(leaf.Mesh);
  marrow::SetIntArray(output->GetCellData(), marrow::names::SegmentId, leaf.Labels);
  output->GetCellData()->SetActiveScalars(marrow::names::SegmentId);
  // Viewers prefer point scalars to cell scalars.
  output->GetPointData()->SetActiveScalars(nullptr);
  marrow::SetArray(output->GetCellData(), marrow::names::SegmentConfidence, leaf.Confidence);
  if (segmentNames && !leaf.IsSource)
  {
    output->GetFieldData()->RemoveArray(marrow::names::SegmentName);
    output->GetFieldData()->AddArray(segmentNames);
  }
  if (!leaf.Rejected.empty())
  {
    WriteRejected(leaf.Rejected, output);
  }
  marrow::WriteNote(leaf.Collected->Side.Surface, output);
  return output;
}

void WriteTable(const std::vector<Leaf>& leaves, vtkTable* table)
{
  vtkNew<vtkStringArray> block;
  block->SetName("Block");
  vtkNew<vtkUnsignedCharArray> isSource;
  isSource->SetName("IsSource");
  vtkNew<vtkStringArray> source;
  source->SetName("Source");
  vtkNew<vtkDoubleArray> confidence;
  confidence->SetName("Confidence");
  vtkNew<vtkDoubleArray> against;
  against->SetName("Against");
  vtkNew<vtkDoubleArray> learning;
  learning->SetName("Learning");
  vtkNew<vtkDoubleArray> heldOut;
  heldOut->SetName("HeldOutAccuracy");
  vtkNew<vtkDoubleArray> heldOutLearnt;
  heldOutLearnt->SetName("HeldOutAccuracyLearnt");
  vtkNew<vtkStringArray> note;
  note->SetName("Note");
  for (const Leaf& leaf : leaves)
  {
    block->InsertNextValue(leaf.Name);
    isSource->InsertNextValue(leaf.IsSource ? 1 : 0);
    source->InsertNextValue(leaf.Source >= 0 ? leaves[leaf.Source].Name : "");
    confidence->InsertNextValue(leaf.MeanConfidence);
    against->InsertNextValue(leaf.Against);
    learning->InsertNextValue(leaf.Learning);
    heldOut->InsertNextValue(leaf.HeldOutAccuracy);
    heldOutLearnt->InsertNextValue(leaf.HeldOutAccuracyLearnt);
    note->InsertNextValue(leaf.Note);
  }
  table->Initialize();
  for (vtkAbstractArray* column :
    { static_cast<vtkAbstractArray*>(block.Get()), static_cast<vtkAbstractArray*>(isSource.Get()),
      static_cast<vtkAbstractArray*>(source.Get()),
      static_cast<vtkAbstractArray*>(confidence.Get()),
      static_cast<vtkAbstractArray*>(against.Get()), static_cast<vtkAbstractArray*>(learning.Get()),
      static_cast<vtkAbstractArray*>(heldOut.Get()),
      static_cast<vtkAbstractArray*>(heldOutLearnt.Get()),
      static_cast<vtkAbstractArray*>(note.Get()) })
  {
    table->AddColumn(column);
  }
}
}

/// What does not depend on labels, kept as long as the meshes are the same.
struct vtkCollectionTransfer::Memory
{
  marrow::CollectedMeshes Meshes;
  marrow::CollectedPairs Pairs;
};

vtkCollectionTransfer::vtkCollectionTransfer()
  : Remembered(new Memory)
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
}

vtkCollectionTransfer::~vtkCollectionTransfer()
{
  this->SetCacheFolder(nullptr);
}

bool vtkCollectionTransfer::CanLearn()
{
#ifdef MARROW_HAS_DLIB
  return true;
#else
  return false;
#endif
}

int vtkCollectionTransfer::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

int vtkCollectionTransfer::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObjectTree" : "vtkTable");
  return 1;
}

int vtkCollectionTransfer::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(info);
  if (input && (!output || !output->IsA(input->GetClassName())))
  {
    vtkSmartPointer<vtkDataObject> tree;
    tree.TakeReference(input->NewInstance());
    info->Set(vtkDataObject::DATA_OBJECT(), tree);
  }
  vtkInformation* ofTable = outputVector->GetInformationObject(1);
  if (!vtkTable::GetData(ofTable))
  {
    ofTable->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
  }
  return 1;
}

int vtkCollectionTransfer::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkDataObjectTree::SafeDownCast(vtkDataObject::GetData(inputVector[0]));
  auto* output = vtkDataObjectTree::SafeDownCast(vtkDataObject::GetData(outputVector, 0));
  output->CopyStructure(input);
  std::vector<Leaf> leaves = LeavesOf(input);
  if (leaves.empty() &&
    vtkStreamingDemandDrivenPipeline::GetUpdatePiece(outputVector->GetInformationObject(0)) > 0)
  {
    return 1; // All is with the first process.
  }
  const auto warn = [this](Leaf& leaf, const std::string& warning)
  {
    AddNote(leaf, warning);
    vtkWarningMacro(<< leaf.Name << ": " << warning);
  };

  const std::string name = marrow::NameOfSegments(this);
  std::vector<vtkPolyData*> meshes;
  std::vector<int> leafOfMesh;
  std::set<int> differentLabels;
  for (std::size_t l = 0; l < leaves.size(); ++l)
  {
    Leaf& leaf = leaves[l];
    if (!leaf.Mesh)
    {
      warn(leaf,
        std::string("it is a ") + leaf.Data->GetClassName() +
          ", not a vtkPolyData, and is left as it is: extract its surface first.");
      continue;
    }
    if (vtkDataArray* array = leaf.Mesh->GetCellData()->GetArray(name.c_str()))
    {
      const std::string error =
        marrow::ToLabels(array, leaf.Mesh->GetNumberOfCells(), "cell", leaf.Labels);
      if (!error.empty())
      {
        warn(leaf, error);
        leaf.Mesh = nullptr;
        continue;
      }
      leaf.IsSource = true;
    }
    meshes.push_back(leaf.Mesh);
    leafOfMesh.push_back(static_cast<int>(l));
  }
  const std::string folder = this->CacheFolder ? this->CacheFolder : "";
  const bool learns = this->LearnFromSources && CanLearn();
  marrow::SharedPairs shared(this->Controller, MembersOf(leaves, leafOfMesh), folder, learns);
  if (shared.IsShared())
  {
    if (folder.empty())
    {
      vtkErrorMacro(
        << "Several processes share the work, but there is no folder by which they tell each "
           "other: set CacheFolder.");
      return 0;
    }
    if (!shared.MatchPairs(marrow::ProgressOf(this, 0.0, OfSharedPairs)))
    {
      return 1;
    }
    if (!shared.IsFirst())
    {
      shared.CarryMaps({}, marrow::ProgressOf(this, OfSharedPairs, 1.0));
      return 1;
    }
  }
  const auto progressOf = [&](double from, double to)
  {
    const double start = shared.IsShared() ? OfSharedPairs : 0.0;
    return marrow::ProgressOf(this, start + (1.0 - start) * from, start + (1.0 - start) * to);
  };
  std::vector<std::shared_ptr<const marrow::CollectedMesh>> collected;
  if (!this->Remembered->Meshes.Collect(meshes, collected, progressOf(0.0, 0.2)))
  {
    return 1;
  }
  bool isAnySource = false;
  for (std::size_t m = 0; m < meshes.size(); ++m)
  {
    Leaf& leaf = leaves[leafOfMesh[m]];
    leaf.Collected = collected[m];
    if (!collected[m]->Error.empty())
    {
      warn(leaf, collected[m]->Error);
      leaf.Mesh = nullptr;
      continue;
    }
    const std::string mended = collected[m]->Side.Surface.Working.Sentence();
    if (!mended.empty())
    {
      AddNote(leaf, mended + ".");
    }
    isAnySource = isAnySource || leaf.IsSource;
    differentLabels.insert(leaf.Labels.begin(), leaf.Labels.end());
  }
  if (!isAnySource)
  {
    vtkErrorMacro(<< "No mesh of the collection has the cell array \"" << name
                  << "\" of segments: label at least one, or choose another array with "
                     "SetInputArrayToProcess.");
    return 0;
  }
  if (differentLabels.size() > static_cast<std::size_t>(marrow::MostPieces))
  {
    vtkErrorMacro(<< "The labelled meshes have " << differentLabels.size()
                  << " different segments, more than " << marrow::MostPieces
                  << ": give equal segments of different meshes equal numbers.");
    return 0;
  }

  const std::vector<ShapeOfLeaf> shapes = ShapesOf(leaves);
  std::vector<int> heldOut;
  std::vector<marrow::CollectionLink> links;
  std::vector<marrow::CollectedPairs::Ends> ends;
  for (const auto& [first, second] : SelectPairsOf(shapes, learns, heldOut))
  {
    marrow::CollectionLink link;
    link.Shapes = { first, second };
    links.push_back(link);
    ends.emplace_back(shapes[first].Shape, shapes[second].Shape);
  }
  std::vector<marrow::ShapePair*> pairs;
  if (!this->Remembered->Pairs.Collect(ends, folder, pairs, progressOf(0.2, 0.6)))
  {
    return 1;
  }
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    links[i].Pair = pairs[i];
  }
  std::vector<const marrow::CollectionShape*> ofGraph;
  std::vector<int> meshOfShape;
  std::vector<std::vector<int>> labelsOfGraph;
  for (const ShapeOfLeaf& shape : shapes)
  {
    ofGraph.push_back(shape.Shape.get());
    meshOfShape.push_back(shape.Leaf);
    labelsOfGraph.push_back(shape.Labels);
  }
  marrow::CollectionGraph graph(
    std::move(ofGraph), meshOfShape, std::move(labelsOfGraph), std::move(links));
  if (!marrow::VoteOnAnswers(graph, progressOf(0.6, 0.65)))
  {
    return 1;
  }
  marrow::ChooseTellers(graph);
  if (shared.IsShared())
  {
    if (!shared.CarryMaps(MapsWantedBy(graph, shapes, leafOfMesh), {}))
    {
      return 1;
    }
    this->Remembered->Pairs.ReadAgain(folder);
  }
  const double afterMaps = heldOut.empty() ? 0.95 : 0.75; // of the progress
  const bool isCarried = marrow::CarryMaps(graph, progressOf(0.65, afterMaps));
  std::vector<marrow::LabelShares> shares;
  if (isCarried)
  {
    shares = marrow::SpreadShares(graph);
    Learn(graph, heldOut, shares, leaves, progressOf(afterMaps, 0.95));
  }
  if (!folder.empty())
  {
    this->Remembered->Pairs.Save(folder);
  }
  if (!isCarried)
  {
    return 1;
  }
  const std::vector<marrow::SpreadLabels> spread =
    marrow::LabelShapes(graph, shares, progressOf(0.95, 1.0));
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  std::vector<std::vector<marrow::RejectedAnswer>> rejected(shapes.size());
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    rejected[s] = marrow::FindRejectedAnswers(graph, static_cast<int>(s), spread[s].Source,
      spread[s].Labels, static_cast<std::size_t>(this->NumberOfRejectedAnswers));
  }
  Collect(shapes, spread, rejected, leaves);

  vtkAbstractArray* segmentNames = nullptr;
  for (const Leaf& leaf : leaves)
  {
    if (leaf.IsSource && leaf.Mesh && !segmentNames)
    {
      segmentNames = leaf.Mesh->GetFieldData()->GetAbstractArray(marrow::names::SegmentName);
    }
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> iterator;
  iterator.TakeReference(input->NewTreeIterator());
  iterator->InitTraversal();
  for (Leaf& leaf : leaves)
  {
    if (leaf.Mesh && leaf.IsWholeAlignment)
    {
      warn(leaf,
        "the skeletons bring it and the labelled meshes together no better than their "
        "principal axes: they are aligned as wholes, and the segments are only as good as "
        "that.");
    }
    if (leaf.Mesh)
    {
      output->SetDataSet(iterator, LabelledMesh(leaf, segmentNames));
    }
    else
    {
      output->SetDataSet(iterator, leaf.Data);
    }
    iterator->GoToNextItem();
  }
  WriteTable(leaves, vtkTable::GetData(outputVector, 1));
  return 1;
}

void vtkCollectionTransfer::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkCollectionTransfer::GetController() const
{
  return this->Controller;
}

void vtkCollectionTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CacheFolder: " << (this->CacheFolder ? this->CacheFolder : "(none)") << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "NumberOfRejectedAnswers: " << this->NumberOfRejectedAnswers << "\n";
  os << indent << "LearnFromSources: " << this->LearnFromSources << "\n";
}
