package nephele.engine.collision;

import java.util.List;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;

/** The shape that a {@link Collider} was made from. */
sealed interface ColliderShape {
    /** Returns the form as a polyhedron in world coordinates, for cutting and for its faces. */
    ConvexPolyhedron polyhedron();

    /**
     * Returns three numbers for each edge: its direction, of any length.
     *
     * @param vertices three numbers each
     */
    double[] edges(double[] vertices);

    /** A convex solid. */
    record Solid(ConvexPolyhedron polyhedron) implements ColliderShape {
        /** Contains an edge twice when two faces share it. */
        @Override
        public double[] edges(double[] vertices) {
            List<ConvexPolyhedron.Face> faces = polyhedron.faces();
            double[] directions = new double
                    [3 * faces.stream().mapToInt(f -> f.polygon().size()).sum()];
            int at = 0;
            for (ConvexPolyhedron.Face face : faces) {
                for (int i = 0; i < face.polygon().size(); i++) {
                    Vec3 a = face.polygon().get(i);
                    Vec3 b = face.polygon().get((i + 1) % face.polygon().size());
                    directions[at++] = b.x() - a.x();
                    directions[at++] = b.y() - a.y();
                    directions[at++] = b.z() - a.z();
                }
            }
            return directions;
        }
    }

    /**
     * The corners of a {@link TriangleCollider}. There are many and few need the polyhedron, so it is built on each request.
     */
    record Sheet(Vec3[] corners) implements ColliderShape {
        @Override
        public ConvexPolyhedron polyhedron() {
            return TriangleCollider.shape(corners);
        }

        /** Returns the directions of the six edges between the four corners. */
        @Override
        public double[] edges(double[] vertices) {
            int[] pairs = {0, 1, 1, 2, 2, 0, 0, 3, 1, 3, 2, 3};
            double[] directions = new double[18];
            for (int i = 0; i < 18; i++) {
                int from = pairs[i / 3 * 2];
                int to = pairs[i / 3 * 2 + 1];
                directions[i] = vertices[3 * to + i % 3] - vertices[3 * from + i % 3];
            }
            return directions;
        }
    }

    /** A sphere or a capsule. */
    record Round(Vec3 halfAxis) implements ColliderShape {
        @Override
        public ConvexPolyhedron polyhedron() {
            throw new IllegalStateException(
                    "a sphere or a capsule has no faces; only static solids are cut or lain on");
        }

        @Override
        public double[] edges(double[] vertices) {
            return new double[] {halfAxis.x(), halfAxis.y(), halfAxis.z()};
        }
    }
}
