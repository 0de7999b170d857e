package nephele.engine.level.billboard;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Billboards;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.RayTriangleIntersection;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;

/** The grounds of the fields of a level: a terrain, or the highest surfaces of everything. */
public final class FieldGrounds {
    private final StaticShapes statics;
    private final Map<String, Ground> terrains = new HashMap<>();
    private Ground surfaces;

    public FieldGrounds(StaticShapes statics) {
        this.statics = statics;
        for (StaticShape.HeightGrid grid : statics.ground()) {
            terrains.put(grid.id(), TerrainGround.of(grid));
        }
    }

    /** Returns the ground of a field; {@code null} if it names a terrain that there is not. */
    public Ground of(Billboards.Field field) {
        if (field.terrain() != null) {
            return terrains.get(field.terrain());
        }
        if (surfaces == null) {
            surfaces = new SurfaceGround(statics);
        }
        return surfaces;
    }

    /** The surface of a terrain alone, whatever stands on it. */
    record TerrainGround(HeightField field) implements Ground {
        static TerrainGround of(StaticShape.HeightGrid grid) {
            return new TerrainGround(grid.field());
        }

        @Override
        public Area area() {
            Aabb bounds = field.bounds();
            return new Area(bounds.minX(), bounds.minZ(), bounds.maxX(), bounds.maxZ());
        }

        @Override
        public Place at(double x, double z) {
            double y = HeightFieldSurface.y(field, x, z);
            return Double.isNaN(y) ? null : new Place(new Vec3(x, y, z), HeightFieldSurface.normal(field, x, z));
        }
    }

    /** The highest surface of all static shapes, as rays from above find it. */
    static final class SurfaceGround implements Ground {
        private static final double ABOVE_METRES = 1;

        private final Aabb bounds;
        private final List<Surface> surfaces = new ArrayList<>();
        private final SpatialIndex index;
        private final RayHit hit = new RayHit();
        private final Ray ray = Ray.reusable();
        private final ItemRayTest test =
                (from, item, limit) -> surfaces().get(item).hit(from, limit);

        /** A part of the ground. */
        private interface Surface {
            double hit(Ray downwards, double limit);

            /** Returns the unit normal at a point that a ray has hit. */
            Vec3 normal(Ray downwards, Vec3 at);
        }

        public SurfaceGround(StaticShapes statics) {
            bounds = statics.bounds();
            List<Aabb> boxes = new ArrayList<>();
            statics.forEach(
                    hull -> {
                        boxes.add(hull.bounds());
                        surfaces.add(new Hull(hull.brush().shape()));
                    },
                    mesh -> addTriangles(mesh.model().triangles().corners(), boxes),
                    grid -> {
                        boxes.add(grid.bounds());
                        surfaces.add(new Grid(grid));
                    });
            index = SpatialIndex.of(boxes);
        }

        private List<Surface> surfaces() {
            return surfaces;
        }

        @Override
        public Area area() {
            return bounds.isEmpty()
                    ? new Area(0, 0, 0, 0)
                    : new Area(bounds.minX(), bounds.minZ(), bounds.maxX(), bounds.maxZ());
        }

        @Override
        public Place at(double x, double z) {
            if (bounds.isEmpty()) {
                return null;
            }
            double top = bounds.maxY() + ABOVE_METRES;
            ray.aim(x, top, z, 0, -1, 0);
            if (!index.nearest(ray, top - bounds.minY() + ABOVE_METRES, test, hit)) {
                return null;
            }
            Vec3 at = new Vec3(x, top - hit.distance(), z);
            Vec3 normal = surfaces.get(hit.item()).normal(ray, at);
            return new Place(at, normal.y() < 0 ? normal.negated() : normal);
        }

        /** Adds the triangles of a mesh, each as a surface. */
        private void addTriangles(double[] corners, List<Aabb> boxes) {
            for (int at = 0; at < corners.length; at += 9) {
                boxes.add(Aabb.of(List.of(corner(corners, at), corner(corners, at + 3), corner(corners, at + 6))));
                surfaces.add(new Triangle(corners, at));
            }
        }

        private static Vec3 corner(double[] corners, int at) {
            return new Vec3(corners[at], corners[at + 1], corners[at + 2]);
        }

        private record Hull(ConvexPolyhedron shape) implements Surface {
            /** The vertical ray enters the hull at the last of the planes that it passes from the front. */
            private Plane entered(Ray downwards) {
                Plane last = null;
                double enter = Double.NEGATIVE_INFINITY;
                double leave = Double.POSITIVE_INFINITY;
                for (ConvexPolyhedron.Face face : shape.faces()) {
                    Plane plane = face.plane();
                    double front = plane.signedDistance(downwards.originX(), downwards.originY(), downwards.originZ());
                    double distance = front / plane.ny();
                    if (plane.ny() > 0 && distance > enter) {
                        enter = distance;
                        last = plane;
                    } else if (plane.ny() < 0) {
                        leave = Math.min(leave, distance);
                    } else if (plane.ny() == 0 && front > 0) {
                        return null;
                    }
                }
                return enter <= leave ? last : null;
            }

            @Override
            public double hit(Ray downwards, double limit) {
                Plane plane = entered(downwards);
                return plane == null ? Double.POSITIVE_INFINITY : distance(plane, downwards);
            }

            private static double distance(Plane plane, Ray downwards) {
                return plane.signedDistance(downwards.originX(), downwards.originY(), downwards.originZ()) / plane.ny();
            }

            @Override
            public Vec3 normal(Ray downwards, Vec3 at) {
                return entered(downwards).normal();
            }
        }

        private record Triangle(double[] corners, int from) implements Surface {
            @Override
            public double hit(Ray downwards, double limit) {
                double distance = RayTriangleIntersection.hitParameter(downwards, corners, from);
                return distance >= 0 ? distance : Double.POSITIVE_INFINITY;
            }

            @Override
            public Vec3 normal(Ray downwards, Vec3 at) {
                Vec3 a = corner(corners, from);
                Vec3 cross = corner(corners, from + 3)
                        .minus(a)
                        .cross(corner(corners, from + 6).minus(a));
                return cross.scaled(1 / Math.max(cross.length(), Double.MIN_NORMAL));
            }
        }

        private record Grid(StaticShape.HeightGrid grid) implements Surface {
            @Override
            public double hit(Ray downwards, double limit) {
                RayHit found = new RayHit();
                return nearest(downwards, limit, found) ? found.distance() : Double.POSITIVE_INFINITY;
            }

            private boolean nearest(Ray downwards, double limit, RayHit found) {
                return grid.field()
                        .nearest(
                                downwards,
                                limit,
                                (ray, item, most) -> grid.field().intersection(ray, item),
                                found);
            }

            @Override
            public Vec3 normal(Ray downwards, Vec3 at) {
                RayHit found = new RayHit();
                return nearest(downwards, Double.POSITIVE_INFINITY, found)
                        ? grid.field().normal(found.item())
                        : new Vec3(0, 1, 0);
            }
        }
    }
}
