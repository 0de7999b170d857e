package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/** A cloud: where it is, what it consists of and the technique that draws it. */
public record Cloud(
        String id,
        Extent extent,
        CloudTechnique technique,
        Density density,
        double extinctionPerMetre,
        double albedo,
        double phaseG) {

    /** Where the cloud is; the file's {@code kind}, its members beside the cloud's own. */
    public sealed interface Extent {
        /** {@code "kind": "volume"}: an axis-aligned box. */
        record Volume(Vec3 centre, Vec3 size) implements Extent {}

        /** {@code "kind": "layer"}. */
        record Layer(double baseAltitudeMetres, double thicknessMetres) implements Extent {}
    }

    /** Density 0–1 inside the extent, times {@code extinctionPerMetre}. */
    public sealed interface Density {
        /** {@code "kind": "image"}: a grey picture as density from above. */
        record Image(String file) implements Density {}

        /** {@code "kind": "ellipsoid"}: 1 inside the inscribed ellipsoid. */
        record Ellipsoid() implements Density {}

        /** {@code "kind": "puffs"}: soft balls. */
        record Puffs(List<Puff> puffs) implements Density {}

        /** {@code "kind": "noise"}. */
        record Noise(long seed, double featureMetres, double coverage) implements Density {}

        /** {@code "kind": "grid"}: a Mitsuba {@code .vol} version 3 file. */
        record Grid(String file) implements Density {}
    }

    /** One soft ball, relative to the extent's centre. */
    public record Puff(Vec3 centre, double radiusMetres) {}
}
