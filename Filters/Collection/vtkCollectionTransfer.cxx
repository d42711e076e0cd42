// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCollectionTransfer.h"

#include "AnswerVote.h"
#include "ArrayNames.h"
#include "CollectedMeshes.h"
#include "CollectedPairs.h"
#include "CollectionLeaf.h"
#include "CollectionOutput.h"
#include "FilterSupport.h"
#include "LabelBridge.h"
#include "LabelSpread.h"
#include "PairSelection.h"
#include "RejectedAnswers.h"
#include "SegmentationTransfer.h"
#include "SharedPairs.h"
#ifdef MARROW_HAS_DLIB
#include "SourceLearning.h"
#endif

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkCollectionTransfer);

namespace
{
/// Of the progress, where several processes share the pairs.
constexpr double OfSharedPairs = 0.6;

/// The leaves that are meshes, in the order of the tree.
std::vector<int> MeshesAmong(const std::vector<marrow::CollectionLeaf>& leaves)
{
  std::vector<int> leafOfMesh;
  for (std::size_t l = 0; l < leaves.size(); ++l)
  {
    if (leaves[l].Mesh)
    {
      leafOfMesh.push_back(static_cast<int>(l));
    }
  }
  return leafOfMesh;
}

std::vector<marrow::CollectionMember> MembersOf(
  const std::vector<marrow::CollectionLeaf>& leaves, const std::vector<int>& leafOfMesh)
{
  std::vector<marrow::CollectionMember> members;
  for (const int l : leafOfMesh)
  {
    members.push_back({ leaves[l].Mesh, leaves[l].IsSource });
  }
  return members;
}

/// What is wrong with the labels, or empty.
std::string ErrorOfLabels(
  const std::vector<marrow::CollectionLeaf>& leaves, const std::string& nameOfArray)
{
  std::set<int> differentLabels;
  for (const marrow::CollectionLeaf& leaf : leaves)
  {
    if (leaf.Mesh)
    {
      differentLabels.insert(leaf.Labels.begin(), leaf.Labels.end());
    }
  }
  if (std::none_of(leaves.begin(), leaves.end(),
        [](const marrow::CollectionLeaf& leaf) { return leaf.Mesh && leaf.IsSource; }))
  {
    return "No mesh of the collection has the cell array \"" + nameOfArray +
      "\" of segments: label at least one, or choose another array with SetInputArrayToProcess.";
  }
  if (differentLabels.size() > static_cast<std::size_t>(marrow::MostPieces))
  {
    return "The labelled meshes have " + std::to_string(differentLabels.size()) +
      " different segments, more than " + std::to_string(marrow::MostPieces) +
      ": give equal segments of different meshes equal numbers.";
  }
  return {};
}

/// The pairs that are worth matching; and, if it `learns`, the leaves whose labels are to be held back.
marrow::PairChoice ChoosePairsOf(const std::vector<marrow::ShapeOfLeaf>& shapes, bool learns)
{
  std::vector<marrow::SketchedShape> sketched;
  for (const marrow::ShapeOfLeaf& shape : shapes)
  {
    sketched.push_back(
      { marrow::SketchOf(shape.Shape->Fine.Skeleton), shape.Leaf, !shape.Labels.empty() });
  }
  return marrow::ChoosePairs(sketched, learns);
}

marrow::CollectionGraph GraphOf(const std::vector<marrow::ShapeOfLeaf>& shapes,
  const std::vector<std::pair<int, int>>& ends, const std::vector<marrow::ShapePair*>& pairs)
{
  std::vector<marrow::CollectionLink> links(ends.size());
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    links[i].Shapes = { ends[i].first, ends[i].second };
    links[i].Pair = pairs[i];
  }
  std::vector<const marrow::CollectionShape*> ofGraph;
  std::vector<int> meshOfShape;
  std::vector<std::vector<int>> labels;
  for (const marrow::ShapeOfLeaf& shape : shapes)
  {
    ofGraph.push_back(shape.Shape.get());
    meshOfShape.push_back(shape.Leaf);
    labels.push_back(shape.Labels);
  }
  return { std::move(ofGraph), std::move(meshOfShape), std::move(labels), std::move(links) };
}

/// Multiplies the shares of the targets by what the leaves that are held out teach.
void Learn([[maybe_unused]] const marrow::CollectionGraph& graph,
  [[maybe_unused]] const std::vector<int>& heldOut,
  [[maybe_unused]] std::vector<marrow::LabelShares>& shares,
  [[maybe_unused]] std::vector<marrow::CollectionLeaf>& leaves,
  [[maybe_unused]] const marrow::Progress& progress)
{
#ifdef MARROW_HAS_DLIB
  const marrow::SourceLessons lessons = marrow::LearnFromSources(graph, heldOut, shares, progress);
  for (marrow::CollectionLeaf& leaf : leaves)
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

/// The maps by which shapes hear their tellers and that are not carried out yet. `leafOfMesh` ascends.
std::vector<marrow::WantedMaps> MapsWantedBy(const marrow::CollectionGraph& graph,
  const std::vector<marrow::ShapeOfLeaf>& shapes, const std::vector<int>& leafOfMesh)
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
  std::vector<marrow::CollectionLeaf> leaves = marrow::LeavesOf(input);
  if (leaves.empty() &&
    vtkStreamingDemandDrivenPipeline::GetUpdatePiece(outputVector->GetInformationObject(0)) > 0)
  {
    return 1; // All is with the first process.
  }
  this->ReadLabels(leaves);
  const std::vector<int> leafOfMesh = MeshesAmong(leaves);
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
  if (!this->CollectMeshes(leafOfMesh, leaves, progressOf(0.0, 0.2)))
  {
    return 1;
  }
  const std::string error = ErrorOfLabels(leaves, marrow::NameOfSegments(this));
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  const std::vector<marrow::ShapeOfLeaf> shapes = marrow::ShapesOf(leaves);
  const marrow::PairChoice choice = ChoosePairsOf(shapes, learns);
  std::vector<marrow::CollectedPairs::Ends> ends;
  for (const auto& [first, second] : choice.Pairs)
  {
    ends.emplace_back(shapes[first].Shape, shapes[second].Shape);
  }
  std::vector<marrow::ShapePair*> pairs;
  if (!this->Remembered->Pairs.Collect(ends, folder, pairs, progressOf(0.2, 0.6)))
  {
    return 1;
  }
  marrow::CollectionGraph graph = GraphOf(shapes, choice.Pairs, pairs);
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
  const double afterMaps = choice.HeldOutMeshes.empty() ? 0.95 : 0.75; // of the progress
  const bool isCarried = marrow::CarryMaps(graph, progressOf(0.65, afterMaps));
  std::vector<marrow::LabelShares> shares;
  if (isCarried)
  {
    shares = marrow::SpreadShares(graph);
    Learn(graph, choice.HeldOutMeshes, shares, leaves, progressOf(afterMaps, 0.95));
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
  marrow::BringToCells(shapes, spread, rejected, leaves);
  this->WriteLeaves(leaves, input, output);
  marrow::WriteTable(leaves, vtkTable::GetData(outputVector, 1));
  return 1;
}

void vtkCollectionTransfer::Warn(marrow::CollectionLeaf& leaf, const std::string& warning)
{
  leaf.AddNote(warning);
  vtkWarningMacro(<< leaf.Name << ": " << warning);
}

void vtkCollectionTransfer::ReadLabels(std::vector<marrow::CollectionLeaf>& leaves)
{
  const std::string name = marrow::NameOfSegments(this);
  for (marrow::CollectionLeaf& leaf : leaves)
  {
    if (!leaf.Mesh)
    {
      this->Warn(leaf,
        std::string("it is a ") + leaf.Data->GetClassName() +
          ", not a vtkPolyData, and is left as it is: extract its surface first.");
    }
    else if (vtkDataArray* array = leaf.Mesh->GetCellData()->GetArray(name.c_str()))
    {
      const std::string error =
        marrow::ToLabels(array, leaf.Mesh->GetNumberOfCells(), "cell", leaf.Labels);
      leaf.IsSource = error.empty();
      if (!error.empty())
      {
        this->Warn(leaf, error);
        leaf.Mesh = nullptr;
      }
    }
  }
}

bool vtkCollectionTransfer::CollectMeshes(const std::vector<int>& leafOfMesh,
  std::vector<marrow::CollectionLeaf>& leaves, const marrow::Progress& progress)
{
  std::vector<vtkPolyData*> meshes;
  for (const int l : leafOfMesh)
  {
    meshes.push_back(leaves[l].Mesh);
  }
  std::vector<std::shared_ptr<const marrow::CollectedMesh>> collected;
  if (!this->Remembered->Meshes.Collect(meshes, collected, progress))
  {
    return false;
  }
  for (std::size_t m = 0; m < meshes.size(); ++m)
  {
    marrow::CollectionLeaf& leaf = leaves[leafOfMesh[m]];
    leaf.Collected = collected[m];
    if (!collected[m]->Error.empty())
    {
      this->Warn(leaf, collected[m]->Error);
      leaf.Mesh = nullptr;
      continue;
    }
    const std::string mended = collected[m]->Side.Surface.Working.Sentence();
    if (!mended.empty())
    {
      leaf.AddNote(mended + ".");
    }
  }
  return true;
}

void vtkCollectionTransfer::WriteLeaves(
  std::vector<marrow::CollectionLeaf>& leaves, vtkDataObjectTree* input, vtkDataObjectTree* output)
{
  vtkAbstractArray* segmentNames = nullptr;
  for (const marrow::CollectionLeaf& leaf : leaves)
  {
    if (leaf.IsSource && leaf.Mesh && !segmentNames)
    {
      segmentNames = leaf.Mesh->GetFieldData()->GetAbstractArray(marrow::names::SegmentName);
    }
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> iterator;
  iterator.TakeReference(input->NewTreeIterator());
  iterator->InitTraversal();
  for (marrow::CollectionLeaf& leaf : leaves)
  {
    if (leaf.Mesh && leaf.IsWholeAlignment)
    {
      this->Warn(leaf,
        "its surface and those of the labelled meshes fit better as wholes than by their "
        "skeletons: they are aligned as wholes, and the segments are only as good as "
        "that.");
    }
    if (leaf.Mesh)
    {
      output->SetDataSet(iterator, marrow::LabelledMesh(leaf, segmentNames));
    }
    else
    {
      output->SetDataSet(iterator, leaf.Data);
    }
    iterator->GoToNextItem();
  }
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
