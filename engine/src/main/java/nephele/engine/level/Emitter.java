package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * A source of particles. Their state is a function of the time alone, and nothing that is simulated depends on it.
 *
 * @param centre of the box that the particles fill, in metres
 * @param size edges of that box, in metres
 * @param startSeconds time of the first particle; before 0 for what has been going on when the level starts
 * @param repeatSeconds time between two explosions; 0 for a single one
 * @param widthMetres width of a particle; 0 for that of its kind
 * @param splashes whether drops of rain are seen to splash where they end
 */
public record Emitter(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, prototype = "\"smoke\"") Kind kind,
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
        @Written(required = true, spatial = Spatial.EXTENT, prototype = "[2, 3, 2]") @Range(min = 0.01, max = 1000)
                Vec3 size,
        @Written(required = true, prototype = "20") @Range(min = 1e-6, max = 1e6, shape = Range.Shape.OR_ZERO)
                double ratePerSecond,
        @Written @Range(min = 0, max = 1e9) int seed,
        @Written @Range double startSeconds,
        @Written @Range(min = 0.1, max = 1e6, shape = Range.Shape.OR_ZERO) double repeatSeconds,
        @Written(spatial = Spatial.LENGTH) @Range(min = 1e-4, max = 100, shape = Range.Shape.OR_ZERO)
                double widthMetres,
        @Written boolean splashes) {
    /** What an emitter makes; its word in a level file is the name in lower case. */
    public enum Kind {
        /** Flames over the base of the box, up to its top. */
        FIRE,
        /** Smoke that rises from the base of the box and spreads. */
        SMOKE,
        /** Drops that fall through the box and end at the first surface. */
        RAIN,
        /** Flakes that drift down through the box and end at the first surface. */
        SNOW,
        /** Glowing specks that the base of the box throws up. */
        SPARKS,
        /** A ball of fire from the centre that turns into smoke: what is emitted in a second, at once. */
        EXPLOSION,
        /**
         * The particles of the report on billboards and particle systems, whose laws are stated for frames: squares that fly
         * from the centre, are slowed down and fade. Each place is taken again as soon as its particle has ended.
         */
        QUADS
    }

    public static final double RAIN_METRES_PER_SECOND = 8;
    public static final double SNOW_METRES_PER_SECOND = 1.1;

    /** Mean life of a quad: it falls from 1 to 0.05 by 0.005 to 0.015 in each of 60 frames a second. */
    private static final double QUAD_MEAN_LIFE_SECONDS = 0.95 / 0.6;

    /** The most particles that a level shows at once. */
    public static final int MOST_PARTICLES = 200_000;

    /** Makes an emitter whose drops do not splash. */
    public Emitter(
            String id,
            Kind kind,
            Vec3 centre,
            Vec3 size,
            double ratePerSecond,
            int seed,
            double startSeconds,
            double repeatSeconds,
            double widthMetres) {
        this(id, kind, centre, size, ratePerSecond, seed, startSeconds, repeatSeconds, widthMetres, false);
    }

    /** Makes an emitter that starts at once, repeats nothing and has particles of the usual width. */
    public Emitter(String id, Kind kind, Vec3 centre, Vec3 size, double ratePerSecond) {
        this(id, kind, centre, size, ratePerSecond, 0, 0, 0, 0);
    }

    /** Returns the longest life of a particle in seconds: small flames are short-lived, and drops fall through the box. */
    public double longestLifeSeconds() {
        return switch (kind) {
            case FIRE -> 0.3 + 0.8 * Math.sqrt(size.y());
            case SMOKE -> 1 + 2.2 * Math.sqrt(size.y());
            case RAIN -> size.y() / RAIN_METRES_PER_SECOND;
            case SNOW -> size.y() / SNOW_METRES_PER_SECOND;
            case SPARKS -> 0.6 + 0.6 * Math.sqrt(size.y());
            case EXPLOSION -> 4.5;
            case QUADS -> 191 / 60.0;
        };
    }

    /** Returns an upper bound of the particles at one time. */
    public double mostAtOnce() {
        return switch (kind) {
            case EXPLOSION -> Math.rint(ratePerSecond);
            case QUADS -> Math.rint(ratePerSecond * QUAD_MEAN_LIFE_SECONDS);
            default -> ratePerSecond == 0 ? 0 : Math.ceil(ratePerSecond * longestLifeSeconds()) + 1;
        };
    }
}
