package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/** A cloud: its extent, its density and the technique that draws it. */
public record Cloud(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(beside = true) Extent extent,
        @Written(absent = "\"auto\"") CloudTechnique technique,
        @Written(absent = "{\"kind\": \"ellipsoid\"}") Density density,
        @Written(absent = "0.05", min = 0, max = 1e3) double extinctionPerMetre,
        @Written(absent = "1", min = 0, max = 1) double albedo,
        @Written(min = -0.999, max = 0.999) double phaseG) {

    /** The region of a cloud. The file has its {@code kind} and members beside the cloud's own. */
    public sealed interface Extent {
        /** {@code "kind": "volume"}: an axis-aligned box. */
        record Volume(
                @Written(required = true, spatial = Spatial.POINT) Vec3 centre,
                @Written(required = true, min = 1e-4, spatial = Spatial.EXTENT, prototype = "[40, 16, 40]") Vec3 size)
                implements Extent {}

        /** {@code "kind": "layer"}. */
        record Layer(
                @Written(required = true, prototype = "1500") double baseAltitudeMetres,
                @Written(required = true, min = 1e-3, prototype = "300") double thicknessMetres)
                implements Extent {}
    }

    /** The density of a cloud, 0 to 1 inside the extent; multiplied by {@code extinctionPerMetre}. */
    public sealed interface Density {
        /** {@code "kind": "image"}: a grey picture that gives the density as seen from above. */
        record Image(@Written(required = true, text = TextKind.ASSET) String file) implements Density {}

        /** {@code "kind": "ellipsoid"}: 1 inside the inscribed ellipsoid. */
        record Ellipsoid() implements Density {}

        /** {@code "kind": "puffs"}: soft balls. */
        record Puffs(@Written(required = true) List<Puff> puffs) implements Density {}

        /** {@code "kind": "noise"}. */
        record Noise(
                @Written(min = -9.007199254740991e15, max = 9.007199254740991e15) long seed,
                @Written(absent = "100", min = 1e-3) double featureMetres,
                @Written(absent = "0.5", min = 0, max = 1) double coverage)
                implements Density {}

        /** {@code "kind": "grid"}: a Mitsuba {@code .vol} version 3 file. */
        record Grid(@Written(required = true, text = TextKind.ASSET) String file) implements Density {}
    }

    /** One soft ball; its centre is relative to the extent's centre. */
    public record Puff(
            @Written(required = true) Vec3 centre, @Written(required = true, min = 1e-4) double radiusMetres) {}
}
