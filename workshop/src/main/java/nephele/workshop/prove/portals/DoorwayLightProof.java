package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.Sun;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.reference.LightTransport;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.tile.TiledPicture;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Traces two rooms with a doorway between them, and the same rooms apart with a pair of portals in its place. The one that
 * the eye is in has no light of its own; the other has sun and sky through a gap in its roof, a lamp and an emissive box.
 */
public final class DoorwayLightProof implements Proof {
    private static final double MOST_SIGMAS = 4;

    /** The distance in standard errors beyond which a pixel differs, and the greatest fraction of those that may. */
    private static final double MOST_PIXEL_SIGMAS = 5;

    private static final double MOST_DIFFERING = 0.0025;
    private static final Vec3 EYE = new Vec3(1.2, 0.6, 3.2);
    private static final Vec3 TARGET = new Vec3(-0.6, -1.2, 0.4);
    private static final double HALF_FIELD = 0.7;

    private final int width;
    private final int height;
    private final int samples;

    /** @param width pixels of the pictures, {@code height} likewise */
    public DoorwayLightProof(int width, int height, int samples) {
        this.width = width;
        this.height = height;
        this.samples = samples;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "doorway-light",
                "A room lit through a pair of portals, bounces included, is as bright as through a doorway in their"
                        + " place: the traced pictures' means are within 4 joint standard errors, and 99.75 % of the"
                        + " pixels within 5.",
                "rooms",
                20,
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        return ProofResult.ofUnits(from, count, progress, unit -> judged(unit));
    }

    private ProofResult judged(long unit) {
        Rooms rooms = Rooms.of(new SplittableRandom(unit));
        TiledPicture open = picture(rooms.withDoorway(), 2 * unit);
        TiledPicture through = picture(rooms.withPortals(), 2 * unit + 1);
        float[] errors = open.standardError();
        float[] others = through.standardError();
        double difference = 0;
        double variance = 0;
        double sum = 0;
        int differing = 0;
        for (int i = 0; i < errors.length; i++) {
            double apart = through.rgb()[i] - open.rgb()[i];
            double square = (double) errors[i] * errors[i] + (double) others[i] * others[i];
            differing += apart * apart > MOST_PIXEL_SIGMAS * MOST_PIXEL_SIGMAS * square ? 1 : 0;
            difference += apart;
            sum += open.rgb()[i];
            variance += 3 * square; // the channels of a pixel have one path: their errors add up as if they were one
        }
        double error = Math.sqrt(variance);
        double sigmas = Math.abs(difference) / error;
        double fraction = (double) differing / errors.length;
        List<String> failures = sigmas <= MOST_SIGMAS && fraction <= MOST_DIFFERING
                ? List.of()
                : List.of(String.format(
                        Locale.ROOT,
                        "room %d: mean off by %.2f standard errors, %.3f %% of the values differ",
                        unit,
                        sigmas,
                        100 * fraction));
        return ProofResult.of(
                1,
                failures,
                Figure.greatest("farthest mean", sigmas, "standard errors"),
                Figure.greatest("greatest standard error of a mean", 100 * error / sum, "%"),
                Figure.sum("values", errors.length, ""),
                Figure.sum("values that differ", differing, ""));
    }

    private TiledPicture picture(Level level, long seed) {
        TracedLevel traced = TracedLevel.of(PlacedLevel.of(level, new ResourceAssets("/")), ColourDecoding.SRGB);
        Basis basis = Basis.lookAt(EYE, TARGET, new Vec3(0, 1, 0), Basis.WORLD);
        Pinhole eye = new Pinhole(EYE, basis, HALF_FIELD, HALF_FIELD * height / width, 0.05, 1e4);
        int threads = Runtime.getRuntime().availableProcessors();
        var settings = new TraceSettings(width, height, samples, seed, threads, LightTransport.FULL);
        return ReferencePicture.picture(traced, eye, settings, done -> {});
    }

    /**
     * A room around z = 2 and another around z = −2, each 4 m wide and long and 3 m high.
     *
     * @param apart distance of the rooms if portals join them
     * @param wide metres of the doorway, as {@code high}
     */
    private record Rooms(double apart, double wide, double high, Vec3 lamp, Vec3 sun) {
        static Rooms of(SplittableRandom random) {
            return new Rooms(
                    40 + 10 * random.nextDouble(),
                    1 + random.nextDouble(),
                    1 + 1.5 * random.nextDouble(),
                    new Vec3(2.5 * random.nextDouble() - 1.2, 1.2 * random.nextDouble(), -1 - 2 * random.nextDouble()),
                    new Vec3(random.nextDouble() - 0.5, 0.5, -0.5 - random.nextDouble()));
        }

        Level withDoorway() {
            List<Solid> solids = both(0);
            double thin = 1e-4;
            double beside = (4.2 - wide) / 2;
            double over = (3.2 - high) / 2;
            for (int side = -1; side <= 1; side += 2) {
                box(solids, "wall", new Vec3(side * (wide + beside) / 2, 0, -thin / 2), new Vec3(beside, 3.2, thin));
                box(solids, "wall", new Vec3(0, side * (high + over) / 2, -thin / 2), new Vec3(wide, over, thin));
            }
            return lit(solids, 0);
        }

        Level withPortals() {
            List<Solid> solids = both(apart);
            box(solids, "wall", new Vec3(0, 0, -0.5), new Vec3(4.4, 3.4, 1));
            box(solids, "wall", new Vec3(apart, 0, 0.5), new Vec3(4.4, 3.4, 1));
            return lit(solids, apart)
                    .withPortals(List.of(
                            portal("a", "b", Vec3.ZERO, new Vec3(0, 0, 1)),
                            portal("b", "a", new Vec3(apart, 0, 0), new Vec3(0, 0, -1))));
        }

        private PortalSpec portal(String id, String other, Vec3 centre, Vec3 normal) {
            return new PortalSpec(id, other, centre, normal, new Vec3(0, 1, 0), wide, high, PortalShape.RECTANGLE);
        }

        private static List<Solid> both(double apart) {
            List<Solid> solids = new ArrayList<>();
            Vec3 offset = new Vec3(apart, 0, 0);
            walls(solids, Vec3.ZERO, 1);
            walls(solids, offset, -1);
            box(solids, "wall", new Vec3(0, 1.6, 2.1), new Vec3(4.4, 0.2, 4.2));
            box(solids, "wall", offset.plus(new Vec3(0, 1.6, -0.5)), new Vec3(4.4, 0.2, 1));
            box(solids, "wall", offset.plus(new Vec3(0, 1.6, -3.35)), new Vec3(4.4, 0.2, 1.7));
            box(solids, "glow", offset.plus(new Vec3(-1.2, -1.1, -3)), new Vec3(0.6, 0.6, 0.6));
            return solids;
        }

        /** Adds the floor and three walls of a room without a roof that begins at z = 0. */
        private static void walls(List<Solid> solids, Vec3 offset, int side) {
            box(solids, "wall", offset.plus(new Vec3(0, -1.6, 2.1 * side)), new Vec3(4.4, 0.2, 4.2));
            box(solids, "wall", offset.plus(new Vec3(0, 0, 4.1 * side)), new Vec3(4.4, 3.4, 0.2));
            box(solids, "wall", offset.plus(new Vec3(2.1, 0, 2.1 * side)), new Vec3(0.2, 3.4, 4.2));
            box(solids, "wall", offset.plus(new Vec3(-2.1, 0, 2.1 * side)), new Vec3(0.2, 3.4, 4.2));
        }

        private static void box(List<Solid> solids, String material, Vec3 centre, Vec3 size) {
            String id = "box-" + solids.size();
            solids.add(new Solid.Box(id, material, false, TextureMapping.WORLD, centre, size, Map.of()));
        }

        private Level lit(List<Solid> solids, double shift) {
            Sky sky = new Sky.Constant(new Vec3(0.4, 0.6, 1));
            var environment = new Environment(
                    new Sun(sun, new Vec3(5, 5, 5), true),
                    sky,
                    null,
                    Exposure.NEUTRAL,
                    ToneCurve.CLIP,
                    null,
                    List.of());
            Light light = new Light.Point("lamp", lamp.plus(new Vec3(shift, 0, 0)), new Vec3(4, 4, 4), 100, true);
            Vec3 grey = new Vec3(0.2, 0.2, 0.2);
            return Level.of("doorway", "", environment, List.of())
                    .with(
                            List.of(
                                    new Material("wall", new Vec3(0.8, 0.7, 0.5), null, null, null, null, Vec3.ZERO, 1),
                                    new Material("glow", grey, null, null, null, null, new Vec3(6, 3, 1), 1)),
                            List.copyOf(solids))
                    .with(environment, List.of(light));
        }
    }
}
