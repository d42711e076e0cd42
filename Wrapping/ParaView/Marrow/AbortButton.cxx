// SPDX-License-Identifier: BSD-3-Clause
#include "AbortButton.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqObjectBuilder.h>
#include <pqPipelineSource.h>
#include <pqProgressManager.h>
#include <pqServerManagerModel.h>
#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProxy.h>

#include <QApplication>
#include <QInputEvent>
#include <QTimer>

#include <cstring>
#include <utility>

namespace
{
constexpr const char* Name = "MarrowAbortButton";
/// Milliseconds between two looks at what the user did.
constexpr qint64 Interval = 50;

/// The filter behind a source of the menu Marrow; null for all others, and on remote servers.
vtkAlgorithm* FilterOf(const pqPipelineSource* source)
{
  vtkPVXMLElement* hints = source->getHints();
  vtkPVXMLElement* menu = hints ? hints->FindNestedElementByName("ShowInMenu") : nullptr;
  const char* category = menu ? menu->GetAttribute("category") : nullptr;
  return category && !std::strcmp(category, "Marrow")
    ? vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject())
    : nullptr;
}

pqProgressManager* ProgressManager()
{
  return pqApplicationCore::instance()->getProgressManager();
}

pqServerManagerModel* Model()
{
  return pqApplicationCore::instance()->getServerManagerModel();
}
}

AbortButton::AbortButton(QObject* parent)
  : QObject(parent)
{
  this->SinceEvents.start();
  for (pqPipelineSource* source : Model()->findItems<pqPipelineSource*>())
  {
    this->Watch(source);
  }
  QObject::connect(Model(), &pqServerManagerModel::sourceAdded, this, &AbortButton::Watch);
  QObject::connect(ProgressManager(), &pqProgressManager::abort, this, &AbortButton::Stop);
}

void AbortButton::Watch(pqPipelineSource* source)
{
  if (vtkAlgorithm* filter = FilterOf(source))
  {
    filter->AddObserver(vtkCommand::StartEvent, this, &AbortButton::FilterStarts);
    filter->AddObserver(vtkCommand::ProgressEvent, this, &AbortButton::FilterProgresses);
    filter->AddObserver(vtkCommand::EndEvent, this, &AbortButton::FilterEnds);
    QObject::connect(source, &pqPipelineSource::modifiedStateChanged, this,
      [this, source]() { this->RunAgainIfApplied(source); });
  }
}

void AbortButton::FilterStarts(vtkObject* filter, unsigned long, void*)
{
  this->Running = vtkAlgorithm::SafeDownCast(filter);
  ProgressManager()->setEnableAbort(true);
}

void AbortButton::FilterProgresses()
{
  if (!this->Running || this->SinceEvents.elapsed() < Interval)
  {
    return;
  }
  // ParaView's own filter of events stops clicks on their way from the window to the button.
  const bool unblocked = ProgressManager()->unblockEvents(true);
  qApp->installEventFilter(this);
  // No timers: they render what may be half done.
  QCoreApplication::processEvents(
    QEventLoop::ExcludeSocketNotifiers | QEventLoop::X11ExcludeTimers);
  qApp->removeEventFilter(this);
  ProgressManager()->unblockEvents(unblocked);
  this->SinceEvents.restart();
}

bool AbortButton::eventFilter(QObject* receiver, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Close:
    case QEvent::DragEnter:
    case QEvent::Shortcut:
      event->ignore();
      return true;
    default:
      break;
  }
  if (!dynamic_cast<QInputEvent*>(event))
  {
    return false;
  }
  // What the mouse does comes to the window first, which hands it on to the widget below the pointer.
  return receiver->isWindowType() ? !dynamic_cast<QMouseEvent*>(event)
                                  : !ProgressManager()->nonBlockableObjects().contains(receiver);
}

void AbortButton::Stop()
{
  for (pqPipelineSource* source : Model()->findItems<pqPipelineSource*>())
  {
    if (this->Running && FilterOf(source) == this->Running)
    {
      this->Running->SetAbortExecuteAndUpdateTime();
      this->Stopping = source;
      this->FirstApply = source->modifiedState() == pqProxy::UNINITIALIZED;
    }
  }
}

void AbortButton::FilterEnds()
{
  this->Running = nullptr;
  ProgressManager()->setEnableAbort(false);
  if (this->Stopping)
  {
    // ParaView runs the filter some more times before it has done with this Apply. Then comes a timer.
    QTimer::singleShot(1, this, [this]() { this->AllowAnotherApply(); });
  }
}

void AbortButton::AllowAnotherApply()
{
  if (!this->Stopping)
  {
    return;
  }
  this->Stopped = std::exchange(this->Stopping, nullptr);
  FilterOf(this->Stopped)->SetAbortExecute(0);
  if (this->FirstApply)
  {
    // What shows no data yet has no colours either. The next Apply makes it anew.
    for (pqDataRepresentation* shown : this->Stopped->getRepresentations(nullptr))
    {
      pqApplicationCore::instance()->getObjectBuilder()->destroy(shown);
    }
  }
  this->Stopped->setModifiedState(this->FirstApply ? pqProxy::UNINITIALIZED : pqProxy::MODIFIED);
}

void AbortButton::RunAgainIfApplied(pqPipelineSource* source)
{
  if (source == this->Stopped && source->modifiedState() == pqProxy::UNMODIFIED)
  {
    this->Stopped = nullptr;
    // The parameters may be as they were, and ParaView would see nothing to do.
    source->getProxy()->MarkDirty(nullptr);
  }
}

void MakeAbortButtonWork()
{
  if (!QCoreApplication::instance())
  {
    return;
  }
  // ParaView loads plugins before it has all that is needed here.
  QTimer::singleShot(0, QCoreApplication::instance(),
    []()
    {
      pqApplicationCore* application = pqApplicationCore::instance();
      // The plugin may be loaded more than once.
      if (application && !application->findChild<QObject*>(Name))
      {
        (new AbortButton(application))->setObjectName(Name);
      }
    });
}
