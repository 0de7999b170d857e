package nephele.workshop.prove.edits;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Edits a town, one record at a time, and compares the derived data with those of the same town freshly loaded. */
public final class EditsProof implements Proof {
    private static final long SEED = 12;

    private static final double MOST_MEDIAN_MS = 16;
    private static final double MOST_P99_MS = 50;
    private static final double MOST_SHADOWS_MS = 500;
    private static final String MEDIAN = "median of an edit";
    private static final String P99 = "99 of 100 edits within";
    private static final String SHADOWS = "shadow maps and picture follow within";

    private static final RenderSettings SETTINGS = RenderSettings.of(Output.DIRECT);
    private static final int WIDTH = 640;
    private static final int HEIGHT = 360;
    private static final int EDITS_BETWEEN_FRAMES = 10;
    private static final int EDITS_BETWEEN_COMPARISONS = 50;

    private final String name;
    private final String lit;
    private final int plots;
    private final int rows;
    private final Function<PlacedLevel, BakedLight> bake;

    /**
     * @param lit what the claim says of the light that is baked; empty if that is the sky's visibility alone
     * @param plots of the town in a row, each of 25 solids
     * @param bake computes the light of an edited town
     */
    public EditsProof(String name, String lit, int plots, int rows, Function<PlacedLevel, BakedLight> bake) {
        this.name = name;
        this.lit = lit;
        this.plots = plots;
        this.rows = rows;
        this.bake = bake;
    }

    @Override
    public Claim claim() {
        return new Claim(
                name,
                "After each of 1,000 random edits of a town of 2,000 solids, 20 lights, sun and sky (seed " + SEED
                        + ")" + lit + ", derivation, collision and upload take at most " + (int) MOST_MEDIAN_MS
                        + " ms CPU in the median and " + (int) MOST_P99_MS
                        + " ms for 99 of 100, and the next picture with its shadow maps follows within "
                        + (int) MOST_SHADOWS_MS
                        + " ms; every fiftieth, and the last with picture and a new bake, equal a fresh load's,"
                        + " bit for bit.",
                "edits",
                1_000,
                1_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        Run run = new Run(progress);
        ByteBuffer last = run.edits(from, count);
        run.compareAll(last);
        return run.result(count);
    }

    /** Judges the limits of time, for which a few edits on a busy machine are not enough. */
    @Override
    public ProofResult judged(ProofResult soFar) {
        List<String> slow = new ArrayList<>();
        judge(soFar, MEDIAN, MOST_MEDIAN_MS, slow);
        judge(soFar, P99, MOST_P99_MS, slow);
        judge(soFar, SHADOWS, MOST_SHADOWS_MS, slow);
        return soFar.and(new ProofResult(0, slow.size(), List.of(), slow));
    }

    private static void judge(ProofResult result, String name, double most, List<String> slow) {
        if (!(result.value(name) <= most)) {
            slow.add(name + " " + result.value(name) + " ms, of " + most);
        }
    }

    /** A town that is drawn while it is edited. */
    private final class Run {
        private final Progress progress;
        private final AssetSource assets = LevelAssets.beside(Path.of("levels", "town.json"));
        private final Stopwatch watch = new Stopwatch();
        private final List<Double> millis = new ArrayList<>();
        private final List<String> failures = new ArrayList<>();
        private final RandomEdits edits;
        private EditedTown town;
        private BakedLight baked;
        /** The current renderer, while there is a context. */
        private Renderer renderer;
        /** The bake in the background; {@code null} if there is none. */
        private CompletableFuture<BakedLight> behind;

        private long editsWhileBaking;
        private double slowestFrame;

        Run(Progress progress) {
            this.progress = progress;
            Level level = Town.of(SEED, plots, rows);
            edits = new RandomEdits(SEED, level);
            PlacedLevel placed = PlacedLevel.of(level, assets);
            baked = bake.apply(placed);
            town = EditedTown.of(placed, baked);
        }

        /** Makes the edits and returns the last picture. */
        ByteBuffer edits(long from, long count) {
            try (GlContext gl = GlContext.offscreen()) {
                renderer = LevelRenderer.load(gl, town.scene(), SETTINGS);
                picture(gl, renderer);
                for (long unit = from; unit < from + count; unit++) {
                    if (unit == from + count / 2) {
                        bakeBehind();
                    }
                    if (unit % EDITS_BETWEEN_FRAMES == 0) {
                        picture(gl, renderer);
                        edit();
                        frame(gl);
                    } else {
                        edit();
                    }
                    if (unit % EDITS_BETWEEN_COMPARISONS == EDITS_BETWEEN_COMPARISONS - 1) {
                        report("edit " + unit, Differences.of(town, fresh()));
                    }
                    progress.unitsDone(unit + 1 - from);
                }
                bakeLast();
                ByteBuffer last = picture(gl, renderer);
                renderer.close();
                return last;
            }
        }

        /** Starts a bake in the background, as an author does while editing continues. */
        private void bakeBehind() {
            PlacedLevel now = town.placed();
            behind = CompletableFuture.supplyAsync(() -> bake.apply(now));
        }

        private void edit() {
            Level level = edits.after(edits.oneOf(RandomEdits.COMMON));
            if (behind != null && behind.isDone()) {
                baked = behind.join();
                behind = null;
            }
            editsWhileBaking += behind == null ? 0 : 1;
            long before = watch.threadCpuNanos();
            show(level);
            millis.add((watch.threadCpuNanos() - before) / 1e6);
        }

        /** Does everything that an edit costs before the next frame is drawn. */
        private void show(Level level) {
            town = town.edited(level, baked);
            renderer = LevelRenderer.edited(renderer, town.scene());
        }

        private void frame(GlContext gl) {
            long before = System.nanoTime();
            picture(gl, renderer);
            slowestFrame = Math.max(slowestFrame, (System.nanoTime() - before) / 1e6);
        }

        /** Waits for the bake in the background and bakes the last state, so that no deferred work remains. */
        private void bakeLast() {
            if (behind != null) {
                behind.join();
            }
            baked = bake.apply(town.placed());
            show(town.placed().level());
        }

        /**
         * Compares with a fresh load in a context of its own, because renderers that share a context could share an
         * error.
         */
        void compareAll(ByteBuffer picture) {
            EditedTown fresh = fresh();
            List<String> differences = new ArrayList<>(Differences.of(town, fresh));
            try (GlContext gl = GlContext.offscreen();
                    Renderer loaded = LevelRenderer.load(gl, fresh.scene(), SETTINGS)) {
                if (!picture.equals(picture(gl, loaded))) {
                    differences.add("picture");
                }
            }
            report("the last edit", differences);
        }

        private EditedTown fresh() {
            return EditedTown.of(PlacedLevel.of(town.placed().level(), assets), baked);
        }

        private void report(String when, List<String> differences) {
            if (!differences.isEmpty()) {
                String example = when + ": " + String.join(", ", differences);
                failures.add(example);
                progress.failed(example);
            }
        }

        ProofResult result(long count) {
            double[] sorted =
                    millis.stream().mapToDouble(Double::doubleValue).sorted().toArray();
            return ProofResult.of(
                    count,
                    failures,
                    Figure.sum("towns that differ from a fresh load's", failures.size(), ""),
                    Figure.greatest(MEDIAN, sorted[sorted.length / 2], "ms"),
                    Figure.greatest(P99, sorted[sorted.length * 99 / 100], "ms"),
                    Figure.greatest("longest", sorted[sorted.length - 1], "ms"),
                    Figure.greatest(SHADOWS, slowestFrame, "ms"),
                    Figure.greatest("edits while a bake ran", editsWhileBaking, ""));
        }
    }

    private static ByteBuffer picture(GlContext gl, Renderer renderer) {
        try (RenderTarget picture = RenderTarget.picture(gl, "town", PixelFormat.RGBA8, WIDTH, HEIGHT)) {
            Camera camera = renderer.scene().level().cameras().get(0);
            renderer.draw(View.ofCamera(camera, 0, WIDTH / (double) HEIGHT), picture);
            gl.requireNoError("town");
            return picture.readBytes();
        }
    }
}
