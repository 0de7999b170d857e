package nephele.engine.level.billboard;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Billboards;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.RayTriangleIntersection;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;

/** Plants the fields of a level: on a terrain, or on the highest surfaces of everything. */
public final class FieldPlanting {
    private final StaticShapes statics;
    private final Map<String, Ground> terrains = new HashMap<>();
    private Ground surfaces;

    public FieldPlanting(StaticShapes statics) {
        this.statics = statics;
        for (StaticShape.HeightGrid grid : statics.ground()) {
            terrains.put(grid.id(), new TerrainGround(grid.field()));
        }
    }

    /** Returns false for a field that names a terrain that there is not. */
    public boolean hasGround(Billboards.Field field) {
        return field.terrain() == null || terrains.containsKey(field.terrain());
    }

    /**
     * Plants a field: as many places as asked for, or as find room.
     *
     * @throws nephele.engine.asset.AssetException that names a density map that cannot be used
     */
    public List<Vec3> plant(Billboards.Field field, AssetSource assets) {
        return plant(field, ground(field), assets);
    }

    private Ground ground(Billboards.Field field) {
        if (field.terrain() != null) {
            return terrains.get(field.terrain());
        }
        if (surfaces == null) {
            surfaces = new SurfaceGround(statics);
        }
        return surfaces;
    }

    static List<Vec3> plant(Billboards.Field field, Ground ground, AssetSource assets) {
        String map = field.densityMap();
        Picture density = map == null ? null : PictureDecoder.decodeNumbers(map, assets.bytes(map));
        Aabb area = ground.bounds();
        double width = area.maxX() - area.minX();
        double depth = area.maxZ() - area.minZ();
        double leastUp = StrictMath.cos(StrictMath.toRadians(field.maxSlopeDegrees()));
        List<Vec3> places = new ArrayList<>();
        PoissonDisc.points(area, field.spacingMetres(), field.count(), field.seed(), (x, z, chance) -> {
            if (density != null && chance >= density(density, (x - area.minX()) / width, (z - area.minZ()) / depth)) {
                return false;
            }
            Place place = ground.at(x, z);
            boolean isGood = place != null && place.normal().y() >= leastUp - 1e-12 && isWithin(field, place);
            if (isGood) {
                places.add(place.at());
            }
            return isGood;
        });
        return places;
    }

    private static boolean isWithin(Billboards.Field field, Place place) {
        Billboards.HeightLimits heights = field.heightRangeMetres();
        double height = place.at().y();
        return heights == null || height >= heights.low() && height <= heights.high();
    }

    /** Returns the first channel of the nearest pixel, 0 to 1. */
    private static double density(Picture map, double u, double v) {
        int x = Math.min((int) (u * map.width()), map.width() - 1);
        int y = Math.min((int) (v * map.height()), map.height() - 1);
        return map.sample(x, y, 0) / (map.bitsPerChannel() == 8 ? 255.0 : 65535.0);
    }

    /** A surface on which things stand: at most one height at a place of the horizontal plane. */
    interface Ground {
        /** Returns the box that it is in; empty for none. */
        Aabb bounds();

        /** Returns the place at x and z; {@code null} where there is no ground. */
        Place at(double x, double z);
    }

    /** A place of the ground. @param normal unit, upwards */
    record Place(Vec3 at, Vec3 normal) {}

    /** The surface of a terrain alone, whatever stands on it. */
    record TerrainGround(HeightField field) implements Ground {
        @Override
        public Aabb bounds() {
            return field.bounds();
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
        private final List<Part> parts = new ArrayList<>();
        private final SpatialIndex index;
        private final RayHit hit = new RayHit();
        private final Ray ray = Ray.reusable();

        SurfaceGround(StaticShapes statics) {
            bounds = statics.bounds();
            List<Aabb> boxes = new ArrayList<>();
            for (StaticShape shape : statics.all()) {
                if (shape instanceof StaticShape.TriangleMesh mesh) {
                    addTriangles(mesh, boxes);
                } else {
                    boxes.add(shape.bounds());
                    parts.add(new Part(shape, null, 0));
                }
            }
            index = SpatialIndex.of(boxes);
        }

        private void addTriangles(StaticShape.TriangleMesh mesh, List<Aabb> boxes) {
            double[] corners = mesh.model().triangles().corners();
            for (int at = 0; at < corners.length; at += 9) {
                boxes.add(Aabb.of(List.of(corner(corners, at), corner(corners, at + 3), corner(corners, at + 6))));
                parts.add(new Part(mesh, corners, at));
            }
        }

        @Override
        public Aabb bounds() {
            return bounds;
        }

        @Override
        public Place at(double x, double z) {
            if (bounds.isEmpty()) {
                return null;
            }
            double top = bounds.maxY() + ABOVE_METRES;
            ray.aim(x, top, z, 0, -1, 0);
            double limit = top - bounds.minY() + ABOVE_METRES;
            if (!index.nearest(ray, limit, (from, item, most) -> parts.get(item).hit(from, most), hit)) {
                return null;
            }
            Vec3 at = new Vec3(x, top - hit.distance(), z);
            Vec3 normal = parts.get(hit.item()).normal(ray);
            return new Place(at, normal.y() < 0 ? normal.negated() : normal);
        }
    }

    private static Vec3 corner(double[] corners, int at) {
        return new Vec3(corners[at], corners[at + 1], corners[at + 2]);
    }

    /**
     * A part of the ground: a convex shape, a height field, or a triangle of a mesh.
     *
     * @param corners x, y and z of each corner of the mesh's triangles; {@code null} for another shape
     * @param from the triangle's first number
     */
    private record Part(StaticShape shape, double[] corners, int from) {
        /** Returns the distance at which a ray downwards meets it, infinite for none. */
        double hit(Ray downwards, double limit) {
            if (shape instanceof StaticShape.ConvexHull hull) {
                Plane plane = entered(hull.brush().shape(), downwards);
                return plane == null ? Double.POSITIVE_INFINITY : distance(plane, downwards);
            } else if (shape instanceof StaticShape.HeightGrid grid) {
                RayHit found = new RayHit();
                return nearest(grid.field(), downwards, limit, found) ? found.distance() : Double.POSITIVE_INFINITY;
            }
            double distance = RayTriangleIntersection.hitParameter(downwards, corners, from);
            return distance >= 0 ? distance : Double.POSITIVE_INFINITY;
        }

        /** Returns the unit normal where a ray downwards meets it. */
        Vec3 normal(Ray downwards) {
            if (shape instanceof StaticShape.ConvexHull hull) {
                return entered(hull.brush().shape(), downwards).normal();
            } else if (shape instanceof StaticShape.HeightGrid grid) {
                RayHit found = new RayHit();
                return nearest(grid.field(), downwards, Double.POSITIVE_INFINITY, found)
                        ? grid.field().normal(found.item())
                        : new Vec3(0, 1, 0);
            }
            Vec3 a = corner(corners, from);
            Vec3 cross = corner(corners, from + 3)
                    .minus(a)
                    .cross(corner(corners, from + 6).minus(a));
            return cross.scaled(1 / Math.max(cross.length(), Double.MIN_NORMAL));
        }

        /** The vertical ray enters the hull at the last of the planes that it passes from the front. */
        private static Plane entered(ConvexPolyhedron shape, Ray downwards) {
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

        private static double distance(Plane plane, Ray downwards) {
            return plane.signedDistance(downwards.originX(), downwards.originY(), downwards.originZ()) / plane.ny();
        }

        private static boolean nearest(HeightField field, Ray downwards, double limit, RayHit found) {
            return field.nearest(downwards, limit, (ray, item, most) -> field.intersection(ray, item), found);
        }
    }
}
