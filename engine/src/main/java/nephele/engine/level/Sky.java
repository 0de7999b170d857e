package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/** Radiance from every direction in which a ray hits nothing, linear RGB. */
public sealed interface Sky {
    /** {@code "kind": "constant"}. */
    record Constant(@Written(required = true) @Range(min = 0, max = 1e9) Vec3 radiance) implements Sky {}

    /** {@code "kind": "gradient"}: a function of the sine of the altitude: horizon at 0, zenith at 1, ground at −1. */
    record Gradient(
            @Written(required = true) @Range(min = 0, max = 1e9) Vec3 zenith,
            @Written(required = true) @Range(min = 0, max = 1e9) Vec3 horizon,
            @Written(absent = "[0, 0, 0]") @Range(min = 0, max = 1e9) Vec3 ground)
            implements Sky {}

    /**
     * {@code "kind": "skybox"}.
     *
     * @param layout the order and orientation of the files, described in docs/skyboxes.md
     * @param files asset ids: one for {@link SkyboxLayout#CROSS}; else six of one square size in the layout's order,
     *     +x, −x, +y, −y, +z, −z for FACES and OPENGL, rt, bk, lf, ft, up, dn for QUAKE2, and front, right, back, left,
     *     up, down for TERRAGEN
     * @param whiteRadiance linear radiance that white in the files stands for
     */
    record Skybox(
            @Written(absent = "\"faces\"", prototype = "\"cross\"") SkyboxLayout layout,
            @Written(required = true, text = TextKind.ASSET, most = 6, prototype = "[\"textures/sky-bay-cross.png\"]")
                    List<String> files,
            @Written(absent = "1") @Range(min = 1e-9, max = 1e9, shape = Range.Shape.OR_ZERO) double whiteRadiance)
            implements Sky {

        /** Creates a skybox whose files hold radiance as it is. */
        public Skybox(SkyboxLayout layout, List<String> files) {
            this(layout, files, 1);
        }
    }

    /**
     * {@code "kind": "atmosphere"}: sunlight scattered in the air around a round planet, whose ground is at y = 0. The
     * environment's sun is then outside the air; without one the hour has the sun. North is −z, east is +x.
     *
     * @param groundAlbedo of the planet
     * @param mieScale aerosols, as a factor on those of clear air
     * @param mieG asymmetry of the aerosols' phase function; positive is forward
     * @param ozoneScale as a factor on the ozone of clear air
     * @param latitudeDegrees positive is north
     * @param dayOfYear 1 is the first of January
     * @param timeOfDayHours true solar time; 12 is noon
     * @param dayLengthSeconds simulated time of a day of 24 hours; 0 for a sun that stands still
     * @param sunRadiusDegrees angular radius of the sun's disc; 0 for a point, which is not drawn and whose shadow in the
     *     air has a hard edge
     */
    record Atmosphere(
            @Written(absent = "0.3") @Range(min = 0, max = 1) double groundAlbedo,
            @Written(absent = "1") @Range(min = 0, max = 100) double mieScale,
            @Written(absent = "0.8") @Range(min = -0.99, max = 0.99) double mieG,
            @Written(absent = "1") @Range(min = 0, max = 10) double ozoneScale,
            @Written(absent = "45") @Range(min = -90, max = 90) double latitudeDegrees,
            @Written(absent = "172") @Range(min = 1, max = 366) double dayOfYear,
            @Written(absent = "10") @Range(min = 0, max = 24) double timeOfDayHours,
            @Written @Range(min = 1, max = 1e9, shape = Range.Shape.OR_ZERO) double dayLengthSeconds,
            @Written(absent = "0.2666") @Range(min = 0.01, max = 5, shape = Range.Shape.OR_ZERO)
                    double sunRadiusDegrees)
            implements Sky {
        /** Clear air in the morning of a summer's day. */
        public static final Atmosphere CLEAR = new Atmosphere(0.3, 1, 0.8, 1, 45, 172, 10, 0, 0.2666);

        /** Returns the sky of the same place and hour with the air and the ground of another one. */
        public Atmosphere withAirOf(Atmosphere other) {
            return new Atmosphere(
                    other.groundAlbedo,
                    other.mieScale,
                    other.mieG,
                    other.ozoneScale,
                    latitudeDegrees,
                    dayOfYear,
                    timeOfDayHours,
                    dayLengthSeconds,
                    sunRadiusDegrees);
        }
    }
}
