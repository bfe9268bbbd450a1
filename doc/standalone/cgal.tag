<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<!-- The pages of CGAL's manual that this one links to, written by hand. -->
<tagfile>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
  <compound kind="group">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="class">
    <name>Kernel</name>
    <filename>Kernel_23/classKernel.html</filename>
  </compound>
  <compound kind="class">
    <name>ConstRange</name>
    <filename>Circulator/classConstRange.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh</name>
    <filename>Surface_mesh/classCGAL_1_1Surface__mesh.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Polyhedron_3</name>
    <filename>Polyhedron/classCGAL_1_1Polyhedron__3.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Sequential_tag</name>
    <filename>STL_Extension/structCGAL_1_1Sequential__tag.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Parallel_tag</name>
    <filename>STL_Extension/structCGAL_1_1Parallel__tag.html</filename>
  </compound>
  <compound kind="class">
    <name>SparseLinearAlgebraWithFactorTraits_d</name>
    <filename>Solver_interface/classSparseLinearAlgebraWithFactorTraits__d.html</filename>
  </compound>
  <compound kind="page">
    <name>thirdparty</name>
    <title>Essential and Optional Third Party Dependencies</title>
    <filename>Manual/thirdparty.html</filename>
    <docanchor file="Manual/thirdparty.html">thirdpartyEigen</docanchor>
    <docanchor file="Manual/thirdparty.html">thirdpartyTBB</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>Manual/license.html</filename>
    <docanchor file="Manual/license.html">licensesGPL</docanchor>
  </compound>
  <compound kind="class">
    <name>CGAL::Eigen_solver_traits</name>
    <filename>Solver_interface/classCGAL_1_1Eigen__solver__traits.html</filename>
  </compound>
</tagfile>
