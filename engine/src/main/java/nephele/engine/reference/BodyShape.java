package nephele.engine.reference;

import java.util.SplittableRandom;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The convex shape of a body around its own centre, in its own frame: a box, a sphere or an upright capsule. */
sealed interface BodyShape {
    static BodyShape of(Body body) {
        if (body instanceof Body.Box box) {
            return new Cuboid(
                    new Vec3(box.size().x() / 2, box.size().y() / 2, box.size().z() / 2));
        } else if (body instanceof Body.Sphere sphere) {
            return new Capsule(sphere.radiusMetres(), 0);
        } else if (body instanceof Body.Capsule capsule) {
            return new Capsule(
                    capsule.radiusMetres(), Math.max(capsule.heightMetres() / 2 - capsule.radiusMetres(), 0));
        }
        throw new IllegalArgumentException("no form for " + body.getClass().getSimpleName());
    }

    /** An interval of a line's parameter; empty if {@code enter} is greater than {@code leave}. */
    record Span(double enter, double leave) {
        static final Span EMPTY = new Span(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);

        private Span within(Span other) {
            return new Span(Math.max(enter, other.enter), Math.min(leave, other.leave));
        }

        boolean isEmpty() {
            return !(enter <= leave);
        }

        /** Returns the hull of both, for two parts of one convex shape. */
        private Span joined(Span other) {
            return isEmpty()
                    ? other
                    : other.isEmpty() ? this : new Span(Math.min(enter, other.enter), Math.max(leave, other.leave));
        }

        /** Returns the interval in which |position + t · speed| is at most {@code half}. */
        private static Span slab(double position, double speed, double half) {
            if (speed == 0) {
                return Math.abs(position) <= half
                        ? new Span(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
                        : EMPTY;
            }
            double a = (-half - position) / speed;
            double b = (half - position) / speed;
            return new Span(Math.min(a, b), Math.max(a, b));
        }

        /** Returns the interval in which a t² + 2 b t + c is not positive. */
        private static Span parabola(double a, double b, double c) {
            if (a == 0) {
                return c <= 0 ? new Span(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY) : EMPTY;
            }
            double root = Math.sqrt(b * b - a * c);
            return root >= 0 ? new Span((-b - root) / a, (-b + root) / a) : EMPTY;
        }
    }

    /** Returns the part of the line from {@code origin} along {@code direction} that is inside. */
    Span span(Vector3dc origin, Vector3dc direction);

    /** Returns the face of {@link nephele.engine.math.ConvexPolyhedron#box} at a point of the surface; 0 if round. */
    int face(Vector3dc p);

    /** Returns the outward unit normal at a point of the surface. */
    Vector3d normal(Vector3dc p);

    /** Returns the area of the surface. */
    double squareMetres();

    /** Returns a random point of the surface, evenly by area. */
    Vector3d place(SplittableRandom random);

    /** Returns the extent from the centre along a unit direction. */
    double reach(Vector3dc direction);

    /**
     * A box.
     *
     * @param half half its sides, metres
     */
    record Cuboid(Vec3 half) implements BodyShape {
        @Override
        public Span span(Vector3dc origin, Vector3dc direction) {
            return Span.slab(origin.x(), direction.x(), half.x())
                    .within(Span.slab(origin.y(), direction.y(), half.y()))
                    .within(Span.slab(origin.z(), direction.z(), half.z()));
        }

        @Override
        public int face(Vector3dc p) {
            double x = Math.abs(p.x()) - half.x();
            double y = Math.abs(p.y()) - half.y();
            double z = Math.abs(p.z()) - half.z();
            int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
            return 2 * axis + (p.get(axis) < 0 ? 1 : 0);
        }

        @Override
        public Vector3d normal(Vector3dc p) {
            int face = face(p);
            return new Vector3d().setComponent(face / 2, (face & 1) == 0 ? 1 : -1);
        }

        @Override
        public double squareMetres() {
            return 8 * (half.x() * half.y() + half.y() * half.z() + half.z() * half.x());
        }

        @Override
        public Vector3d place(SplittableRandom random) {
            double[] h = {half.x(), half.y(), half.z()};
            double at = random.nextDouble() * squareMetres() / 8;
            int axis = at < h[1] * h[2] ? 0 : at < h[1] * h[2] + h[2] * h[0] ? 1 : 2;
            Vector3d p = new Vector3d(
                    h[0] * (2 * random.nextDouble() - 1),
                    h[1] * (2 * random.nextDouble() - 1),
                    h[2] * (2 * random.nextDouble() - 1));
            return p.setComponent(axis, random.nextInt(2) == 0 ? -h[axis] : h[axis]);
        }

        @Override
        public double reach(Vector3dc direction) {
            return half.x() * Math.abs(direction.x())
                    + half.y() * Math.abs(direction.y())
                    + half.z() * Math.abs(direction.z());
        }
    }

    /**
     * A capsule.
     *
     * @param halfAxis from the centre to the centre of a cap, along y; 0 for a sphere
     */
    record Capsule(double radius, double halfAxis) implements BodyShape {
        @Override
        public Span span(Vector3dc origin, Vector3dc direction) {
            double a = direction.x() * direction.x() + direction.z() * direction.z();
            double b = origin.x() * direction.x() + origin.z() * direction.z();
            double c = origin.x() * origin.x() + origin.z() * origin.z() - radius * radius;
            Span barrel = Span.parabola(a, b, c).within(Span.slab(origin.y(), direction.y(), halfAxis));
            return barrel.joined(cap(origin, direction, halfAxis)).joined(cap(origin, direction, -halfAxis));
        }

        private Span cap(Vector3dc origin, Vector3dc direction, double height) {
            Vector3d o = new Vector3d(origin).sub(0, height, 0);
            return Span.parabola(direction.lengthSquared(), o.dot(direction), o.lengthSquared() - radius * radius);
        }

        @Override
        public int face(Vector3dc p) {
            return 0;
        }

        @Override
        public Vector3d normal(Vector3dc p) {
            return new Vector3d(p)
                    .sub(0, Math.min(Math.max(p.y(), -halfAxis), halfAxis), 0)
                    .normalize();
        }

        @Override
        public double squareMetres() {
            return 4 * Math.PI * radius * (radius + halfAxis);
        }

        /** A sphere's height over its middle is as even as that of the barrel between its halves (Archimedes). */
        @Override
        public Vector3d place(SplittableRandom random) {
            double height = (2 * random.nextDouble() - 1) * (radius + halfAxis);
            double inCap = Math.copySign(Math.max(Math.abs(height) - halfAxis, 0), height);
            double angle = 2 * Math.PI * random.nextDouble();
            double flat = Math.sqrt(radius * radius - inCap * inCap);
            return new Vector3d(flat * StrictMath.cos(angle), height, flat * StrictMath.sin(angle));
        }

        @Override
        public double reach(Vector3dc direction) {
            return radius + halfAxis * Math.abs(direction.y());
        }
    }
}
