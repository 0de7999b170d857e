package nephele.engine.scene.light.bake;

import nephele.engine.math.Ray;
import nephele.engine.math.RayTriangleIntersection;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;

/** A shape that blocks rays. */
sealed interface Occluder {
    /** Returns the least t, 0 ≤ t ≤ {@code length}, for which o + t · d is in or on it; infinity for none. */
    double entry(double[] o, double[] d, double length);

    /** Returns true if a point is inside or on the surface; an open surface contains no point. */
    boolean contains(double[] p);

    /**
     * The intersection of half-spaces, four numbers per plane; exact at edges, so that touching solids leave no gap.
     */
    record Convex(double[] planes) implements Occluder {
        /** Clips the line by every plane (Cyrus and Beck 1978); the rest is inside. */
        @Override
        public double entry(double[] o, double[] d, double length) {
            double enter = 0;
            double leave = length;
            for (int i = 0; i < planes.length; i += 4) {
                double along = planes[i] * d[0] + planes[i + 1] * d[1] + planes[i + 2] * d[2];
                double distance = planes[i + 3] - planes[i] * o[0] - planes[i + 1] * o[1] - planes[i + 2] * o[2];
                if (along > 0) {
                    leave = Math.min(leave, distance / along);
                } else if (along < 0) {
                    enter = Math.max(enter, distance / along);
                } else if (distance < 0) {
                    return Double.POSITIVE_INFINITY;
                }
                if (enter > leave) {
                    return Double.POSITIVE_INFINITY;
                }
            }
            return enter;
        }

        /** Returns the plane through which a ray that intersects it enters, −1 for one that begins inside. */
        int entryPlane(double[] o, double[] d) {
            double enter = 0;
            int plane = -1;
            for (int i = 0; i < planes.length; i += 4) {
                double along = planes[i] * d[0] + planes[i + 1] * d[1] + planes[i + 2] * d[2];
                double distance = planes[i + 3] - planes[i] * o[0] - planes[i + 1] * o[1] - planes[i + 2] * o[2];
                if (along < 0 && distance / along > enter) {
                    enter = distance / along;
                    plane = i / 4;
                }
            }
            return plane;
        }

        @Override
        public boolean contains(double[] p) {
            for (int i = 0; i < planes.length; i += 4) {
                if (planes[i] * p[0] + planes[i + 1] * p[1] + planes[i + 2] * p[2] > planes[i + 3]) {
                    return false;
                }
            }
            return true;
        }
    }

    /** A triangle of a non-convex mesh: nine numbers from {@code at}. */
    record Triangle(double[] corners, int at) implements Occluder {
        @Override
        public double entry(double[] o, double[] d, double length) {
            double t = RayTriangleIntersection.hitParameter(o[0], o[1], o[2], d[0], d[1], d[2], corners, at);
            return t >= 0 && t <= length ? t : Double.POSITIVE_INFINITY;
        }

        @Override
        public boolean contains(double[] p) {
            return false;
        }
    }

    /** A terrain; below it everything is inside. */
    record Ground(HeightField field) implements Occluder {
        @Override
        public double entry(double[] o, double[] d, double length) {
            Ray ray = new Ray(o[0], o[1], o[2], d[0], d[1], d[2]);
            RayHit hit = new RayHit();
            boolean isHit = field.nearest(ray, length, (r, triangle, most) -> field.intersection(r, triangle), hit);
            return isHit ? hit.distance() : Double.POSITIVE_INFINITY;
        }

        @Override
        public boolean contains(double[] p) {
            return p[1] <= HeightFieldSurface.y(field, p[0], p[2]);
        }
    }
}
