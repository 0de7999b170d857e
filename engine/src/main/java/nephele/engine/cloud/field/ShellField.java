package nephele.engine.cloud.field;

import java.util.OptionalDouble;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * A layer around the round planet: the field of a flat layer, at the altitude over the sphere that touches the plane y =
 * 0 at the origin. A point (x, y, z) has what the flat layer has at (x, altitude, z). Along a ray x and z stay linear,
 * and the altitude is a convex function, so that within a chunk of the ray it lies below its chord by at most the
 * chunk's sagitta; the flat field must be made for that slack.
 */
public final class ShellField implements ExtinctionField {
    /** The planet's radius, as in docs/atmosphere.md. */
    static final double PLANET_METRES = 6_360_000;

    /** The greatest sagitta. */
    static final double SLACK_METRES = 0.05;

    private static final double CHUNK_METRES = Math.sqrt(8 * SLACK_METRES * PLANET_METRES);

    private final ExtinctionField flat;

    /** @param flat a layer whose majorants hold for points up to {@link #SLACK_METRES} below the walked ray */
    ShellField(ExtinctionField flat) {
        this.flat = flat;
    }

    /** Returns the layer over flat ground. */
    public ExtinctionField flat() {
        return flat;
    }

    /** Returns the altitude over the sphere, without the cancellation of a difference of two radii. */
    static double altitude(double x, double y, double z) {
        double up = PLANET_METRES + y;
        double across = x * x + z * z;
        double distance = Math.sqrt(up * up + across);
        return up > 0 ? y + across / (distance + up) : distance - PLANET_METRES;
    }

    @Override
    public double perMetre(double x, double y, double z) {
        return flat.perMetre(x, altitude(x, y, z), z);
    }

    @Override
    public boolean isEmpty() {
        return flat.isEmpty();
    }

    /** Returns the box of the whole shell. */
    @Override
    public Aabb bounds() {
        double outer = PLANET_METRES + flat.bounds().maxY();
        return new Aabb(-outer, -PLANET_METRES - outer, -outer, outer, outer - PLANET_METRES, outer);
    }

    @Override
    public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
        return new ShellWalk(flat, ray, spans(ray, fromMetres, toMetres));
    }

    /** Returns the exact length in the shell if the flat field is the same everywhere. */
    @Override
    public OptionalDouble closedDepth(Ray ray, double fromMetres, double toMetres) {
        if (!(flat instanceof UniformField uniform)) {
            return OptionalDouble.empty();
        }
        double metres = 0;
        for (RaySpan span : spans(ray, fromMetres, toMetres)) {
            metres += span.isEmpty() ? 0 : span.toMetres() - span.fromMetres();
        }
        return OptionalDouble.of(uniform.extinctionPerMetre() * metres);
    }

    /** Returns the parts of a ray inside the shell: before and behind the ball that it encloses. */
    private RaySpan[] spans(Ray ray, double fromMetres, double toMetres) {
        RaySpan outer = ball(ray, flat.bounds().maxY(), fromMetres, toMetres);
        RaySpan inner = ball(ray, flat.bounds().minY(), Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        if (inner.isEmpty()) {
            return new RaySpan[] {outer};
        }
        return new RaySpan[] {
            new RaySpan(outer.fromMetres(), Math.min(outer.toMetres(), inner.fromMetres())),
            new RaySpan(Math.max(outer.fromMetres(), inner.toMetres()), outer.toMetres())
        };
    }

    /**
     * Returns the part of a ray below an altitude. The constant of the quadratic equation is a product of a difference
     * of altitudes, and the root of smaller size is the quotient of the other, so that no digits cancel.
     */
    private static RaySpan ball(Ray ray, double altitudeMetres, double fromMetres, double toMetres) {
        if (!ray.isCastable() || altitudeMetres <= -PLANET_METRES) {
            return RaySpan.EMPTY;
        }
        double x = ray.originX();
        double y = ray.originY();
        double z = ray.originZ();
        double eye = altitude(x, y, z);
        double half = x * ray.directionX() + (PLANET_METRES + y) * ray.directionY() + z * ray.directionZ();
        double constant = (eye - altitudeMetres) * (2 * PLANET_METRES + eye + altitudeMetres);
        double discriminant = half * half - constant;
        if (!(discriminant > 0)) {
            return RaySpan.EMPTY;
        }
        double larger = -half - Math.copySign(Math.sqrt(discriminant), half);
        double smaller = constant / larger;
        return new RaySpan(
                Math.max(fromMetres, Math.min(larger, smaller)), Math.min(toMetres, Math.max(larger, smaller)));
    }

    /** Walks the chunks of the spans, each as a straight ray of the flat layer. */
    private static final class ShellWalk implements MajorantWalk {
        private final ExtinctionField flat;
        private final Ray ray;
        private final RaySpan[] spans;
        private int span;
        private double chunkFrom;
        private double chunkTo = Double.NaN;
        private MajorantWalk walk;

        private ShellWalk(ExtinctionField flat, Ray ray, RaySpan[] spans) {
            this.flat = flat;
            this.ray = ray;
            this.spans = spans;
        }

        @Override
        public boolean next() {
            do {
                while (walk == null || !walk.next()) {
                    if (!nextChunk()) {
                        return false;
                    }
                    walk = flat.walk(chord(), 0, chunkTo - chunkFrom);
                }
                // Far away, rounding can leave nothing of a short segment.
            } while (!(toMetres() > fromMetres()));
            return true;
        }

        private boolean nextChunk() {
            if (Double.isNaN(chunkTo)) {
                chunkTo = spans[0].fromMetres();
            }
            while (!(chunkTo < spans[span].toMetres())) {
                if (++span == spans.length) {
                    span--;
                    return false;
                }
                chunkTo = spans[span].fromMetres();
            }
            chunkFrom = chunkTo;
            chunkTo = Math.min(spans[span].toMetres(), chunkFrom + CHUNK_METRES);
            return true;
        }

        /** Returns the chunk in the flat layer's space, with the same parameter. */
        private Ray chord() {
            double length = chunkTo - chunkFrom;
            double x = ray.originX() + chunkFrom * ray.directionX();
            double z = ray.originZ() + chunkFrom * ray.directionZ();
            double first = inside(x, ray.originY() + chunkFrom * ray.directionY(), z);
            double last = inside(
                    x + length * ray.directionX(),
                    ray.originY() + chunkTo * ray.directionY(),
                    z + length * ray.directionZ());
            return new Ray(x, first, z, ray.directionX(), (last - first) / length, ray.directionZ());
        }

        /** Returns the altitude, not outside of the layer by rounding. */
        private double inside(double x, double y, double z) {
            Aabb layer = flat.bounds();
            return Math.max(layer.minY(), Math.min(layer.maxY(), altitude(x, y, z)));
        }

        @Override
        public double fromMetres() {
            return chunkFrom + walk.fromMetres();
        }

        @Override
        public double toMetres() {
            return chunkFrom + walk.toMetres();
        }

        @Override
        public double perMetre() {
            return walk.perMetre();
        }
    }
}
