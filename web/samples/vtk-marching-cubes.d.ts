// The one module of vtk.js used here that comes without types.
declare module '@kitware/vtk.js/Filters/General/ImageMarchingCubes.js' {
  import type vtkImageData from '@kitware/vtk.js/Common/DataModel/ImageData.js';
  import type vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData.js';

  interface ImageMarchingCubes {
    setInputData(image: vtkImageData): void;
    getOutputData(): vtkPolyData;
  }

  const vtkImageMarchingCubes: {
    newInstance(options: { contourValue: number; mergePoints: boolean }): ImageMarchingCubes;
  };
  export default vtkImageMarchingCubes;
}
