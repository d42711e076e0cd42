// SPDX-License-Identifier: BSD-3-Clause
#ifndef AbortButton_h
#define AbortButton_h

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>

class pqPipelineSource;
class vtkAlgorithm;
class vtkObject;

/// Makes the button beside ParaView's progress bar stop the filters of Marrow. ParaView 5.11 shows that
/// button, but nothing in it ever enables it, nor are clicks looked at while a filter runs. ParaView
/// 5.12 does both for all filters; here those of others are left as they are.
///
/// Filters on a remote server have no object on this side, and their button stays grey.
class AbortButton : public QObject
{
public:
  explicit AbortButton(QObject* parent);

  /// While a filter runs, keeps from ParaView whatever the user does but for clicks at the button.
  bool eventFilter(QObject* receiver, QEvent* event) override;

private:
  void Watch(pqPipelineSource* source);
  void FilterStarts(vtkObject* filter, unsigned long, void*);
  void FilterProgresses();
  void FilterEnds();
  void Stop();
  void AllowAnotherApply();
  void RunAgainIfApplied(pqPipelineSource* source);

  vtkAlgorithm* Running = nullptr;
  /// The source of it, once the button was clicked.
  QPointer<pqPipelineSource> Stopping;
  bool FirstApply = false;
  /// The source that was stopped last, until it is applied again.
  QPointer<pqPipelineSource> Stopped;
  QElapsedTimer SinceEvents;
};

/// ParaView calls this when it loads the plugin. Does nothing where there is no window: in pvpython,
/// pvbatch and pvserver.
void MakeAbortButtonWork();

#endif
