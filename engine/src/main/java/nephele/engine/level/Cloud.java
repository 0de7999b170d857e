package nephele.engine.level;

import java.util.List;
import java.util.Optional;
import nephele.engine.math.Vec3;

/**
 * A cloud: its extent, its density and the technique that draws it.
 *
 * @param extinctionPerMetre where the density is 1
 * @param albedo scattering divided by extinction
 * @param phaseG mean cosine of the scattering angle, in the first lobe; positive is forward
 * @param shafts whether its shadow is seen in the air
 */
public record Cloud(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(beside = true) Extent extent,
        @Written(absent = "\"auto\"") CloudTechnique technique,
        @Written(absent = "{\"kind\": \"ellipsoid\"}") Density density,
        @Written(absent = "0.05") @Range(min = 1e-9, max = 1e3, shape = Range.Shape.OR_ZERO) double extinctionPerMetre,
        @Written(absent = "1") @Range(min = 0, max = 1) double albedo,
        @Written @Range(min = -0.999, max = 0.999) double phaseG,
        @Written(beside = true) BackLobe backLobe,
        @Written(beside = true) Motion motion,
        @Written boolean shafts,
        @Written(beside = true) Tolerance tolerance) {

    /** Creates a cloud whose phase function has one lobe and whose shadow is not seen in the air. */
    public Cloud(
            String id,
            Extent extent,
            CloudTechnique technique,
            Density density,
            double extinctionPerMetre,
            double albedo,
            double phaseG,
            Motion motion) {
        this(
                id,
                extent,
                technique,
                density,
                extinctionPerMetre,
                albedo,
                phaseG,
                BackLobe.NONE,
                motion,
                false,
                Tolerance.USUAL);
    }

    /** Returns the cloud with another extinction. */
    public Cloud withExtinction(double perMetre) {
        return RecordCopy.with(this, "extinctionPerMetre", perMetre);
    }

    /** Returns the cloud with another motion. */
    public Cloud with(Motion other) {
        return RecordCopy.with(this, "motion", other);
    }

    /** Returns the cloud drawn by another technique. */
    public Cloud with(CloudTechnique other) {
        return RecordCopy.with(this, "technique", other);
    }

    /** Returns the cloud with another error that is allowed. */
    public Cloud with(Tolerance other) {
        return RecordCopy.with(this, "tolerance", other);
    }

    /** Creates a cloud that neither drifts nor changes. */
    public Cloud(
            String id,
            Extent extent,
            CloudTechnique technique,
            Density density,
            double extinctionPerMetre,
            double albedo,
            double phaseG) {
        this(id, extent, technique, density, extinctionPerMetre, albedo, phaseG, Motion.STILL);
    }

    /** The region of a cloud. The file has its {@code kind} and members beside the cloud's own. */
    public sealed interface Extent {
        /** {@code "kind": "volume"}: an axis-aligned box. */
        record Volume(
                @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
                @Written(required = true, spatial = Spatial.EXTENT, prototype = "[40, 16, 40]") @Range(min = 1e-4)
                        Vec3 size)
                implements Extent {}

        /** {@code "kind": "layer"}: endless; under a sky of kind atmosphere a shell around the planet. */
        record Layer(
                @Written(required = true, prototype = "1500") @Range double baseAltitudeMetres,
                @Written(required = true, prototype = "300") @Range(min = 1e-3) double thicknessMetres)
                implements Extent {}
    }

    /** The density of a cloud, 0 to 1 inside the extent; multiplied by {@code extinctionPerMetre}. */
    public sealed interface Density {
        /** Returns the id of the picture or grid that the density is read from; empty for none. */
        default Optional<String> assetId() {
            return Optional.empty();
        }

        /**
         * {@code "kind": "image"}: a picture as seen from above. Its alpha, if it has one, is how much the cloud hides;
         * otherwise its grey is the density.
         */
        record Image(
                @Written(required = true, text = TextKind.ASSET, prototype = "\"textures/clouds/painted.png\"")
                        String file)
                implements Density {
            @Override
            public Optional<String> assetId() {
                return Optional.of(file);
            }
        }

        /** {@code "kind": "ellipsoid"}: 1 inside the inscribed ellipsoid. */
        record Ellipsoid() implements Density {}

        /**
         * {@code "kind": "puffs"}: soft balls.
         *
         * @param fill makes more of them; {@code null} for none
         */
        record Puffs(@Written List<Puff> puffs, @Written PuffFill fill) implements Density {}

        /**
         * {@code "kind": "noise"}.
         *
         * @param featureMetres size of the largest billows
         * @param coverage share of the sky that is meant to be covered
         * @param erosion how far wisps eat into the edges
         * @param profile {@code null} for noise that fills the extent evenly from base to top
         * @param coverageMap a grey picture as seen from above that multiplies the coverage, without a profile the density;
         *     {@code null} for none
         * @param anvil how far the top spreads
         */
        record Noise(
                @Written @Range(min = -9.007199254740991e15, max = 9.007199254740991e15) long seed,
                @Written(absent = "100") @Range(min = 1e-3) double featureMetres,
                @Written(absent = "0.5") @Range(min = 0, max = 1) double coverage,
                @Written @Range(min = 0, max = 1) double erosion,
                @Written CloudProfile profile,
                @Written(text = TextKind.ASSET) String coverageMap,
                @Written @Range(min = 0, max = 1) double anvil)
                implements Density {

            /** Creates noise that fills the extent evenly and has round edges. */
            public Noise(long seed, double featureMetres, double coverage) {
                this(seed, featureMetres, coverage, 0, null, null, 0);
            }

            @Override
            public Optional<String> assetId() {
                return Optional.ofNullable(coverageMap);
            }
        }

        /** {@code "kind": "grid"}: a Mitsuba {@code .vol} version 3 file. */
        record Grid(@Written(required = true, text = TextKind.ASSET, prototype = "\"clouds/heap.vol\"") String file)
                implements Density {
            @Override
            public Optional<String> assetId() {
                return Optional.of(file);
            }
        }
    }

    /** One soft ball; its centre is relative to the extent's centre. */
    public record Puff(
            @Written(required = true) @Range Vec3 centre,
            @Written(required = true) @Range(min = 1e-4) double radiusMetres) {}

    /**
     * Blocks that are filled with puffs.
     *
     * @param count of all puffs together
     */
    public record PuffFill(
            @Written(required = true, most = 1000, prototype = "[{\"centre\": [0, 0, 0], \"size\": [20, 10, 20]}]")
                    List<FillBox> boxes,
            @Written(absent = "200") @Range(min = 0, max = 100_000) int count,
            @Written @Range(min = -9.007199254740991e15, max = 9.007199254740991e15) long seed) {}

    /** One block; its centre is relative to the extent's centre. */
    public record FillBox(
            @Written(required = true) @Range Vec3 centre,
            @Written(required = true, prototype = "[20, 10, 20]") @Range(min = 1e-3) Vec3 size) {}

    /**
     * The second lobe of a cloud's phase function. The file has the members beside the cloud's own.
     *
     * @param phaseBackG mean cosine of its scattering angle; negative is backward
     * @param phaseBackShare share of the light that it scatters; 0 for one lobe
     */
    public record BackLobe(
            @Written @Range(min = -0.999, max = 0.999) double phaseBackG,
            @Written @Range(min = 0, max = 1) double phaseBackShare) {
        public static final BackLobe NONE = new BackLobe(0, 0);
    }

    /**
     * How a cloud changes with simulated time. The file has the members beside the cloud's own.
     *
     * @param windMetresPerSecond a volume moves with it as a whole, a layer's pattern drifts with its x and z
     * @param swayMetres how far it is carried besides, and back
     * @param swaySeconds time in which it goes there and comes back
     * @param evolutionSeconds time in which noise takes another shape; 0 for a shape that stays
     */
    public record Motion(
            @Written(absent = "[0, 0, 0]") @Range(min = -200, max = 200) Vec3 windMetresPerSecond,
            @Written(absent = "[0, 0, 0]") @Range(min = -1e5, max = 1e5) Vec3 swayMetres,
            @Written(absent = "60") @Range(min = 1, max = 1e9) double swaySeconds,
            @Written @Range(min = 1, max = 1e9, shape = Range.Shape.OR_ZERO) double evolutionSeconds) {
        private static final double USUAL_SWAY_SECONDS = 60;

        public static final Motion STILL = new Motion(Vec3.ZERO, 0);

        /** Creates the motion of a cloud that does not come back. */
        public Motion(Vec3 windMetresPerSecond, double evolutionSeconds) {
            this(windMetresPerSecond, Vec3.ZERO, USUAL_SWAY_SECONDS, evolutionSeconds);
        }

        /** Returns how far it has been carried since time 0, metres. */
        public Vec3 drift(double seconds) {
            Vec3 drift = windMetresPerSecond.scaled(seconds);
            if (swayMetres.equals(Vec3.ZERO)) {
                return drift;
            }
            double turn = StrictMath.IEEEremainder(seconds, swaySeconds) / swaySeconds;
            return drift.addScaled(0.5 - 0.5 * StrictMath.cos(2 * Math.PI * turn), swayMetres);
        }

        /** Returns its greatest speed, metres per second. */
        public double greatestSpeed() {
            return windMetresPerSecond.length() + Math.PI * swayMetres.length() / swaySeconds;
        }
    }

    /**
     * The error that technique auto may choose. The file has the members beside the cloud's own.
     *
     * @param maxErrorPixels by which what is seen may be displaced, of a picture 1,280 pixels wide
     * @param maxErrorPercent root mean square of the radiance's error where the cloud is seen, over tenths of the
     *     picture's width, in per cent of its mean
     */
    public record Tolerance(
            @Written(absent = "1") @Range(min = 0, max = 1e4) double maxErrorPixels,
            @Written(absent = "10") @Range(min = 0, max = 1e4) double maxErrorPercent) {
        public static final Tolerance USUAL = new Tolerance(1, 10);
    }
}
