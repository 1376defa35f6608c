//! Do grains stay where obstacles keep them, and bounce as they must? Segments, chains and polygons, triangles and meshes.

mod billiards;
mod boxes;
mod carried;
mod drawn;
mod hourglass;
mod joints;
mod kept;
mod lasting;
mod moving;
mod moving_any;
mod numbers;
mod refused;
mod rooms;
mod shapes;
