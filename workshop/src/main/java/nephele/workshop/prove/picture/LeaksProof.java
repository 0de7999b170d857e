package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.bake.LightBake;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.LightMapChart;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.Occluders;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.scene.probe.LitSurfaces;
import nephele.engine.scene.probe.SkyProbes;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Bakes closed rooms and looks for light on the wrong side of their walls, and for dark texels where charts meet. */
public final class LeaksProof implements Proof {
    /** Light on the wrong side, divided by the mean on the right one. */
    private static final double MOST_LEAKED = 1e-5;

    /** Light of a texel, divided by that of the darkest one beside it. */
    private static final double LEAST_AT_SEAM = 0.5;

    /** Light that is seen and is more than noise, of the mean. */
    private static final double SEEN = 0.1;

    /** Distance from a texel's place to the edge of its chart at most, and a little more. */
    private static final double EDGE_METRES = 3e-3;

    private static final double COPLANAR = 1e-6;

    /** Few rays: what leaks does so along any of them, and seams stand out from their noise. */
    private static final LightBake.Settings COARSE = new LightBake.Settings(1, 128);

    /** The height at which a place on a surface is in no other that touches it. */
    private static final double ABOVE_METRES = 1e-4;

    /** Pieces into which the edge of a chart is divided to measure how much of it another one shares. */
    private static final int EDGE_STEPS = 64;

    private static final int EYES = 4;
    private static final double[][] DIRECTIONS = SkyProbes.evenly(64);
    private static final String LEAKED = "greatest light on the wrong side, of the mean on the right one";
    private static final String SEAM = "least light of a texel, of the least beside it across a shared edge";

    @Override
    public Claim claim() {
        return new Claim(
                "leaks",
                "In closed rooms of walls of 10 cm, however these meet, the texels inside and the light that a"
                        + " picture shows there, and probes, have at most 1e-5 of the mean light outside under a noon"
                        + " sun, and so have those outside of the mean inside with a lamp there; with it, no texel"
                        + " inside has less than half of the bounced light of the darkest one beside it across a"
                        + " shared edge of coplanar charts.",
                "rooms",
                1000,
                20);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        return ProofResult.ofUnits(from, count, progress, unit -> judged(unit));
    }

    /** Balances the noon alone, which takes a third of the time: what its last gathering adds leaks from a lamp too. */
    private static ProofResult judged(long unit) {
        LeakRoom room = new LeakRoom(unit);
        BakedRoom noon = new BakedRoom(room, room.atNoon(), bake -> bake.balance(done -> {}));
        double leaked = noon.leaked(true);
        double shown = noon.shown() / noon.mean(false);
        double probes = noon.probes() / noon.mean(false);
        BakedRoom lamp = new BakedRoom(room, room.withLamp(), bake -> bake.run(LightBake.Checkpoint.NONE, done -> {}));
        double outward = lamp.leaked(false);
        double[] seams = {Double.POSITIVE_INFINITY, 0};
        lamp.findSeams(seams);
        List<String> failures = new ArrayList<>();
        double most = Math.max(Math.max(leaked, outward), Math.max(shown, probes));
        if (!(most <= MOST_LEAKED) || !(seams[0] >= LEAST_AT_SEAM)) {
            failures.add(String.format(
                    Locale.ROOT,
                    "room %d: texels inside %.2g, outside %.2g, shown %.2g, probes %.2g, seam %.3f",
                    unit,
                    leaked,
                    outward,
                    shown,
                    probes,
                    seams[0]));
        }
        return ProofResult.of(
                1,
                failures,
                Figure.sum("texels", 2.0 * noon.layout.width() * noon.layout.height(), ""),
                Figure.greatest(LEAKED, most, ""),
                Figure.sum("texels beside another chart", seams[1], ""),
                Figure.least(SEAM, seams[0], ""));
    }

    /** A room with its light. */
    private static final class BakedRoom {
        private final LeakRoom room;
        private final LightMapLayout layout;
        private final IndirectLight light;
        private final IndirectLight.Layer all;
        private final StaticShapes statics;
        private final Scene scene;

        BakedRoom(LeakRoom room, Level level, Consumer<LightBake> work) {
            this.room = room;
            var placed = PlacedLevel.of(level, new ResourceAssets(LevelAssets.JAR_LEVELS));
            LightBake bake = LightBake.of(placed, COARSE);
            work.accept(bake);
            light = bake.light();
            all = light.sum(true, name -> 1);
            statics = placed.statics();
            layout = LightMapLayout.of(statics.solids());
            short[] sky = new short[layout.width() * layout.height()];
            scene = Scene.of(placed, new BakedLight(new SkyVisibility(layout, statics, sky, new short[0]), light));
        }

        private double at(IndirectLight.Layer layer, int chart, int column, int row) {
            int texel = (layout.rowOf()[chart] + row) * layout.width() + layout.columnOf()[chart] + column;
            return layer.texels().radiance()[3 * texel];
        }

        /** What is done with each texel. */
        private interface Visit {
            void texel(int chart, int column, int row, Vec3 place);
        }

        private void texels(boolean isInside, Visit visit) {
            for (int i = 0; i < layout.charts().size(); i++) {
                LightMapChart chart = layout.charts().get(i);
                for (int row = 0; row < chart.rows(); row++) {
                    for (int column = 0; column < chart.columns(); column++) {
                        Vec3 place = Vec3.of(chart.inside(column, row));
                        if (room.isInside(place) == isInside) {
                            visit.texel(i, column, row, place);
                        }
                    }
                }
            }
        }

        double mean(boolean isInside) {
            double[] sums = new double[2];
            texels(isInside, (chart, column, row, place) -> {
                sums[0] += at(all, chart, column, row);
                sums[1]++;
            });
            return sums[0] / sums[1];
        }

        /** Returns the light of the brightest texel on one side of the walls, divided by the mean on the other. */
        double leaked(boolean isInside) {
            double[] most = new double[1];
            texels(isInside, (chart, column, row, place) -> most[0] = Math.max(most[0], at(all, chart, column, row)));
            return most[0] / mean(!isInside);
        }

        /** Returns the brightest light that eyes inside see on surfaces, interpolated as in a picture. */
        double shown() {
            LitSurfaces surfaces = new LitSurfaces(scene);
            Occluders occluders = surfaces.occluders();
            RayHit hit = new RayHit();
            double[] rgb = new double[3];
            double most = 0;
            for (int eye = 0; eye < EYES; eye++) {
                Vec3 from = room.freePlace();
                double[] o = {from.x(), from.y(), from.z()};
                for (double[] d : DIRECTIONS) {
                    Ray ray = new Ray(o[0], o[1], o[2], d[0], d[1], d[2]);
                    boolean isHit = occluders.nearest(
                            ray, Double.MAX_VALUE, (sight, item, limit) -> occluders.hit(item, o, d, limit), hit);
                    if (!isHit || !room.isInside(ray.at(hit.distance()))) {
                        return Double.POSITIVE_INFINITY;
                    }
                    surfaces.arriving(hit.item(), occluders.faceOf(hit.item(), o, d), ray.at(hit.distance()), rgb);
                    most = Math.max(most, rgb[0]);
                }
            }
            return most;
        }

        /** Returns the brightest light on a side of a thing inside. */
        double probes() {
            SkyProbes probes = new SkyProbes(statics, () -> new LitSurfaces(scene), SkyProbes.Sampling.USUAL);
            float[] values = new float[SkyProbes.LIT_VALUES];
            double most = 0;
            for (int i = 0; i < EYES; i++) {
                Vec3 place = room.freePlace();
                probes.at(place.x(), place.y(), place.z(), values, 0);
                for (int at = SkyProbes.VALUES; at < values.length; at++) {
                    most = Math.max(most, values[at]);
                }
            }
            return most;
        }

        /**
         * Compares bounced light: that straight from a lamp ends at shadows, which may be where charts meet.
         *
         * @param found receives the least light of a visible texel at the edge of a chart, divided by that of the darkest
         *     texel of another chart beside it, then the number of pairs
         */
        void findSeams(double[] found) {
            IndirectLight.Layer bounced = light.sum(false, name -> 1);
            Occluders occluders = new Occluders(statics);
            double mean = mean(true);
            texels(true, (chart, column, row, place) -> {
                Vec3 above = place.addScaled(
                        ABOVE_METRES, Vec3.of(layout.charts().get(chart).normal()));
                if (occluders.isInside(new double[] {above.x(), above.y(), above.z()}, -1)) {
                    return;
                }
                for (int other = 0; other < layout.charts().size(); other++) {
                    if (other != chart && areJoined(chart, other, place)) {
                        double beside = leastAround(bounced, other, place);
                        if (beside > SEEN * mean) {
                            found[0] = Math.min(found[0], at(bounced, chart, column, row) / beside);
                            found[1]++;
                        }
                    }
                }
            });
        }

        /** Returns true if a place of a chart is at an edge that it shares with another; a corner is none. */
        private boolean areJoined(int chart, int other, Vec3 place) {
            LightMapChart first = layout.charts().get(chart);
            LightMapChart second = layout.charts().get(other);
            Vec3 normal = Vec3.of(second.normal());
            boolean isCoplanar = normal.dot(Vec3.of(first.normal())) > 1 - COPLANAR
                    && Math.abs(normal.dot(second.outline().get(0).minus(place))) < COPLANAR;
            if (!isCoplanar || second.metresOutside(place) > EDGE_METRES) {
                return false;
            }
            for (int i = 0; i < first.outline().size(); i++) {
                Vec3 from = first.outline().get(i);
                Vec3 to = first.outline().get((i + 1) % first.outline().size());
                if (isAlong(from, to, place) && sharedMetres(from, to, second) > EDGE_METRES) {
                    return true;
                }
            }
            return false;
        }

        private static boolean isAlong(Vec3 from, Vec3 to, Vec3 place) {
            Vec3 along = Directions.unit(to.minus(from));
            return along.cross(place.minus(from)).length() < EDGE_METRES;
        }

        /** Returns the length of an edge that is on the border of a chart. */
        private static double sharedMetres(Vec3 from, Vec3 to, LightMapChart chart) {
            double length = to.minus(from).length();
            int shared = 0;
            for (int i = 0; i < EDGE_STEPS; i++) {
                Vec3 place = from.addScaled((i + 0.5) / EDGE_STEPS, to.minus(from));
                shared += Math.abs(chart.metresOutside(place)) < COPLANAR ? 1 : 0;
            }
            return length * shared / EDGE_STEPS;
        }

        private double leastAround(IndirectLight.Layer layer, int index, Vec3 place) {
            LightMapChart chart = layout.charts().get(index);
            double column = chart.columnOf(place);
            double row = chart.rowOf(place);
            double least = Double.POSITIVE_INFINITY;
            for (int y = (int) row; y <= Math.ceil(row); y++) {
                for (int x = (int) column; x <= Math.ceil(column); x++) {
                    least = Math.min(least, at(layer, index, x, y));
                }
            }
            return least;
        }
    }
}
