#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <string>

// Damages a particle file as damaged_folders.txt asks for.
namespace {

/// The first particles alone.
vtkNew<vtkPolyData> kept(vtkPolyData* all, vtkIdType count) {
  vtkNew<vtkPolyData> some;
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  some->GetPointData()->CopyAllocate(all->GetPointData());
  some->AllocateExact(count, count);
  for (vtkIdType p = 0; p < count; ++p) {
    points->InsertNextPoint(all->GetPoint(p));
    some->GetPointData()->CopyData(all->GetPointData(), p, p);
    some->InsertNextCell(VTK_VERTEX, 1, &p);
  }
  some->SetPoints(points);
  some->SetFieldData(all->GetFieldData());
  return some;
}

void set(vtkPolyData* data, const std::string& name, vtkIdType first, vtkIdType last, double value) {
  auto* array = name == "position" ? data->GetPoints()->GetData() : data->GetPointData()->GetArray(name.c_str());
  for (vtkIdType p = first; p <= last; ++p) {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c) array->SetComponent(p, c, value);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  const std::string what = arguments[2];
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(arguments[1]);
  reader->Update();
  vtkSmartPointer<vtkPolyData> data = reader->GetOutput();
  if (what == "keep") {
    data = kept(data, std::atol(arguments[3])).Get();
  } else if (what == "drop") {
    data->GetPointData()->RemoveArray(arguments[3]);
  } else if (count == 6) {
    set(data, what, std::atol(arguments[3]), std::atol(arguments[4]), std::strtod(arguments[5], nullptr));
  } else {
    return 2;
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(arguments[1]);
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  return writer->Write() == 1 ? 0 : 1;
}
