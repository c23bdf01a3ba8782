// An angle of 80 x 60 mm, 40 mm wide, 8 mm thick, with a hole of 20 mm in its foot; in mm
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 80, 40, 8};
Box(2) = {0, 0, 8, 8, 40, 52};
Cylinder(3) = {52, 20, -1, 0, 0, 10, 10};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(5) = { Volume{4}; Delete; }{ Volume{3}; Delete; };
Mesh.MeshSizeMax = 16;
Mesh.MeshSizeFromCurvature = 8;
Physical Volume("SOLID") = {5};
hole[] = Surface In BoundingBox{41, 9, -0.1, 63, 31, 8.1};
top[] = Surface In BoundingBox{-0.1, -0.1, 59.9, 8.1, 40.1, 60.1};
Physical Surface("HOLE") = {hole[]};
Physical Surface("TOP") = {top[]};
Mesh.SaveGroupsOfNodes = 1;
