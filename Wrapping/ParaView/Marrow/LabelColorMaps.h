// SPDX-License-Identifier: BSD-3-Clause
#ifndef LabelColorMaps_h
#define LabelColorMaps_h

/// Tells ParaView's settings that the arrays of labels that Marrow's filters make have the colours of
/// vtkMarrowLabelColors, so that equal labels have equal colours on every mesh. ParaView calls this when it
/// loads the plugin. Settings that users save for an array come before these.
void RegisterLabelColorMaps();

#endif
