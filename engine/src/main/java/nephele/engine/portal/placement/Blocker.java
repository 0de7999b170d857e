package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** An obstacle of a shot: a solid, or a piece of surface that belongs to none. */
sealed interface Blocker {
    Aabb bounds();

    /** Returns the outlines of its faces. */
    List<List<Vec3>> loops();

    /** Returns the ray parameter of the first hit; infinity for a miss. */
    double entry(Ray ray);

    /** Returns the patch that the ray hits; negative for the back of one. */
    int patch(Ray ray);

    /** Returns the upward component of the unit normal of the face that the ray hits, on the ray's side. */
    double upwards(Ray ray);

    /** A convex solid; only entries count, so a shot from inside passes through. */
    record Convex(Brush brush, int firstPatch) implements Blocker {
        /** A ray that starts at most this far behind a face, and goes inwards, counts as starting on it. */
        private static final double ON_SURFACE = 1e-9;

        @Override
        public Aabb bounds() {
            return brush.shape().bounds();
        }

        @Override
        public List<List<Vec3>> loops() {
            return brush.faces().stream().map(Brush.BrushFace::polygon).toList();
        }

        @Override
        public double entry(Ray ray) {
            int face = enteredFace(ray);
            if (face < 0) {
                return Double.POSITIVE_INFINITY;
            }
            double front = front(plane(face), ray);
            return front >= -ON_SURFACE ? Math.max(0, -front / rate(plane(face), ray)) : Double.POSITIVE_INFINITY;
        }

        @Override
        public int patch(Ray ray) {
            return firstPatch + enteredFace(ray);
        }

        @Override
        public double upwards(Ray ray) {
            return plane(enteredFace(ray)).ny();
        }

        private Plane plane(int face) {
            return brush.faces().get(face).plane();
        }

        /** Clips against half-spaces (Cyrus and Beck 1978); −1 for a miss. */
        private int enteredFace(Ray ray) {
            double enter = Double.NEGATIVE_INFINITY;
            double leave = Double.POSITIVE_INFINITY;
            int entered = -1;
            for (int i = 0; i < brush.faces().size(); i++) {
                double rate = rate(plane(i), ray);
                double front = front(plane(i), ray);
                if (rate < 0 && -front / rate > enter) {
                    enter = -front / rate;
                    entered = i;
                } else if (rate > 0) {
                    leave = Math.min(leave, -front / rate);
                } else if (rate == 0 && front > 0) {
                    return -1;
                }
            }
            return enter < leave ? entered : -1;
        }
    }

    /**
     * A piece of surface without thickness. It extends beyond its edges by the width of a crack, so that no shot passes
     * between adjacent pieces separated by noise.
     *
     * @param sides planes through its edges, facing outwards
     */
    record Sheet(SurfacePolygon shape, Plane plane, List<Plane> sides, int patchIndex) implements Blocker {
        static Sheet of(SurfacePolygon shape, int patchIndex) {
            Vec3 n = shape.normal();
            List<Plane> sides = new ArrayList<>();
            for (int i = 0; i < shape.corners().size(); i++) {
                Vec3 a = shape.corners().get(i);
                Vec3 b = shape.corners().get((i + 1) % shape.corners().size());
                Vec3 out = b.minus(a).cross(n);
                Vec3 unit = Directions.unit(out);
                if (unit != null) {
                    sides.add(new Plane(unit.x(), unit.y(), unit.z(), unit.dot(a) + Tolerance.CRACK));
                }
            }
            Plane plane = new Plane(n.x(), n.y(), n.z(), n.dot(shape.corners().get(0)));
            return new Sheet(shape, plane, List.copyOf(sides), patchIndex);
        }

        @Override
        public Aabb bounds() {
            return shape.bounds().grown(Tolerance.CRACK);
        }

        @Override
        public List<List<Vec3>> loops() {
            return List.of(shape.corners());
        }

        @Override
        public double entry(Ray ray) {
            double at = -front(plane, ray) / rate(plane, ray);
            if (!(at >= 0 && at < Double.POSITIVE_INFINITY)) {
                return Double.POSITIVE_INFINITY;
            }
            for (Plane side : sides) {
                if (front(side, ray) + at * rate(side, ray) > 0) {
                    return Double.POSITIVE_INFINITY;
                }
            }
            return at;
        }

        @Override
        public int patch(Ray ray) {
            return rate(plane, ray) < 0 ? patchIndex : -1;
        }

        @Override
        public double upwards(Ray ray) {
            return rate(plane, ray) < 0 ? plane.ny() : -plane.ny();
        }
    }

    private static double front(Plane plane, Ray ray) {
        return plane.signedDistance(ray.originX(), ray.originY(), ray.originZ());
    }

    private static double rate(Plane plane, Ray ray) {
        return plane.nx() * ray.directionX() + plane.ny() * ray.directionY() + plane.nz() * ray.directionZ();
    }
}
