// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_HtmlReport_h
#define marrow_HtmlReport_h

#include "Method.h"
#include "ResultTable.h"
#include "Summary.h"

#include <string>
#include <utility>
#include <vector>

namespace marrow::bench
{
/// A pair and the PNG file that shows it.
using Picture = std::pair<Result, std::string>;

/// Writes the summary with plots and pictures as one HTML file that needs no other. Throws
/// std::runtime_error.
void WriteHtmlReport(const std::string& path, const Method& method,
  const std::vector<SummaryRow>& summary, const std::vector<Result>& pairs,
  const std::vector<Result>& meshes, const std::vector<Picture>& pictures);
}

#endif
