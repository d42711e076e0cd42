// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ErrorObserver_h
#define marrow_ErrorObserver_h

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <string>
#include <vector>

namespace marrow::test
{
/// Collects what a filter says through vtkErrorMacro and vtkWarningMacro, and keeps it off the
/// console. Observes the executive too, which reports missing inputs.
///
///   ErrorObserver errors(filter);
///   filter->Update();
///   EXPECT_TRUE(errors.HasError("names a point that does not exist")) << errors.Text();
class ErrorObserver
{
public:
  explicit ErrorObserver(vtkAlgorithm* algorithm)
  {
    this->Collector->Observer = this;
    for (vtkObject* object :
      { static_cast<vtkObject*>(algorithm), static_cast<vtkObject*>(algorithm->GetExecutive()) })
    {
      object->AddObserver(vtkCommand::ErrorEvent, this->Collector);
      object->AddObserver(vtkCommand::WarningEvent, this->Collector);
    }
  }
  ~ErrorObserver() { this->Collector->Observer = nullptr; }
  ErrorObserver(const ErrorObserver&) = delete;
  ErrorObserver& operator=(const ErrorObserver&) = delete;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

  bool HasError(const std::string& part) const { return Contains(this->Errors, part); }
  bool HasWarning(const std::string& part) const { return Contains(this->Warnings, part); }
  /// Everything heard, for a failing assertion's message.
  std::string Text() const
  {
    std::string text;
    for (const auto* list : { &this->Errors, &this->Warnings })
    {
      for (const std::string& message : *list)
      {
        text += message;
      }
    }
    return text;
  }
  void Clear()
  {
    this->Errors.clear();
    this->Warnings.clear();
  }

private:
  class Command : public vtkCommand
  {
  public:
    static Command* New() { return new Command; }
    void Execute(vtkObject*, unsigned long event, void* data) override
    {
      if (this->Observer)
      {
        auto& list =
          event == vtkCommand::ErrorEvent ? this->Observer->Errors : this->Observer->Warnings;
        list.push_back(data ? static_cast<const char*>(data) : "");
      }
    }
    ErrorObserver* Observer = nullptr;
  };

  static bool Contains(const std::vector<std::string>& list, const std::string& part)
  {
    for (const std::string& message : list)
    {
      if (message.find(part) != std::string::npos)
      {
        return true;
      }
    }
    return false;
  }

  vtkNew<Command> Collector;
};
}

#endif
