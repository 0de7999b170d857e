package nephele.editor.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import nephele.editor.draw.LightProgress.Stage;
import nephele.engine.bake.LightBake;
import nephele.engine.level.Light;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.StoredLight;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.LightCache;
import nephele.engine.scene.light.bake.LightKey;
import nephele.engine.work.SwingThread;

/**
 * The light of a level that is edited, read or worked out in the background while the former light is drawn: the sky's
 * visibility, and if it is wanted the light that bounces, first coarse, then fine from the place of the last edit on. An
 * edit on which that light depends ends its bake and begins another one. Only the work itself leaves the drawing thread.
 */
final class EditedLight implements AutoCloseable {
    /** The share of a fine bake after which it is shown for the first time; then whenever that has doubled. */
    private static final double FIRST_SHOWN = 1.0 / 16;

    private final BackgroundWork work;
    /** {@code null} while none runs. */
    private Job job;
    /** The last light that was ready; {@code null} for none. */
    private BakedLight light;
    /** The level at the last call; {@code null} before the first. */
    private PlacedLevel followed;
    /** The {@link LightKey#fileName} of that level, which takes some 15 ms for 2,000 solids; {@code null} if not needed. */
    private CompletableFuture<String> key;
    /** The same of the level whose bounced light was worked out last, or is; empty for none. */
    private String bakedKey = "";

    private boolean isBaked;
    /** The shapes for which a sky's visibility was looked for last. */
    private StaticShapes lit;

    private Vec3 lastEdit = Vec3.ZERO;
    private StoredLight stored;
    private String failure;

    EditedLight(BackgroundWork work) {
        this.work = work;
    }

    /** Returns the light that the next picture would use, perhaps of an earlier version; {@code null} for none. */
    BakedLight light() {
        if (job != null) {
            boolean isDone = job.isDone();
            light = job.latest;
            stored = job.stored == null ? stored : job.stored;
            failure = job.failure;
            if (isDone) {
                bakedKey = isFound() && !job.isBake ? stored.file() : bakedKey;
                job = null;
            }
        }
        return light;
    }

    private boolean isFound() {
        return stored != null && stored.state() == StoredLight.State.BAKED;
    }

    /** Returns true if bounced light of this level, or of an earlier version of it, was found when it was opened. */
    boolean isKnown() {
        return stored != null && stored.state() != StoredLight.State.MISSING;
    }

    LightProgress progress() {
        return job == null ? LightProgress.NONE : job.progress;
    }

    /**
     * Begins what this version of the level needs.
     *
     * @param bakes whether bounced light is baked if there is none
     * @param eye where the user is; the first bake begins there
     */
    void follow(PlacedLevel placed, boolean bakes, Vec3 eye) {
        light();
        boolean isEdited = placed != followed;
        if (isEdited) {
            lastEdit = followed == null ? eye : placeOfEdit(followed, placed).orElse(lastEdit);
        }
        if (!bakes) {
            key = null;
        } else if (isEdited || key == null) {
            key = CompletableFuture.supplyAsync(() -> LightKey.of(placed).fileName(), work.soon());
            key.whenComplete((name, failed) -> work.repaintSoon().run());
        }
        followed = placed;
        if (bakes && !key.isDone()) {
            return;
        }
        boolean isOther = bakes ? !key.join().equals(bakedKey) : isBaked;
        if (job != null && isOther && job.progress != LightProgress.NONE) {
            job.cancel();
            job = null;
        }
        boolean needsSky = placed.statics() != lit && (lit == null || LightRequirements.skyVisibility(placed.level()));
        if (job == null && (needsSky || isOther)) {
            lit = placed.statics();
            isBaked = bakes;
            bakedKey = bakes ? key.join() : bakedKey;
            job = new Job(placed, bakes, lastEdit, light);
            job.begin();
        }
    }

    /** Returns the middle of the shapes and lights that differ between two versions; empty if none does. */
    static Optional<Vec3> placeOfEdit(PlacedLevel before, PlacedLevel now) {
        List<Aabb> changed = new ArrayList<>();
        StaticShapes shapes = before.statics();
        StaticShapes others = now.statics();
        for (var brush : differing(shapes.solids(), others.solids())) {
            changed.add(brush.shape().bounds());
        }
        for (PlacedModel model :
                differing(shapes.models().all(), others.models().all())) {
            changed.add(model.bounds());
        }
        for (var grid : differing(shapes.ground(), others.ground())) {
            changed.add(grid.bounds());
        }
        for (Light lamp : differing(before.level().lights(), now.level().lights())) {
            changed.add(Aabb.around(lamp.position(), Vec3.ZERO));
        }
        return changed.stream().reduce(Aabb::union).map(Aabb::centre);
    }

    private static <T> List<T> differing(List<T> before, List<T> now) {
        List<T> all = new ArrayList<>();
        if (before != now) {
            addNew(IdentityDiff.previousIndices(before, now), now, all);
            addNew(IdentityDiff.previousIndices(now, before), before, all);
        }
        return all;
    }

    private static <T> void addNew(int[] previous, List<T> list, List<T> to) {
        for (int i = 0; i < previous.length; i++) {
            if (previous[i] == IdentityDiff.NEW) {
                to.add(list.get(i));
            }
        }
    }

    /** Returns what the user should know, a line each. */
    List<String> messages() {
        List<String> messages = new ArrayList<>();
        if (stored != null && !isBaked) {
            String name = followed.assets()
                    .levelFile()
                    .map(file -> file.getFileName().toString())
                    .orElse("LEVEL");
            stored.warning(name).ifPresent(messages::add);
        }
        if (failure != null) {
            messages.add(failure);
        }
        return messages;
    }

    @Override
    public void close() {
        if (job != null) {
            job.cancel();
        }
    }

    /** The work for one version of the level. */
    private final class Job {
        private final PlacedLevel placed;
        private final boolean isBake;
        private final Vec3 near;
        private final BakedLight former;
        private CompletableFuture<Void> done;
        private double shownAt = FIRST_SHOWN;
        private int percent;
        private volatile BakedLight latest;
        private volatile StoredLight stored;
        private volatile String failure;
        private volatile LightProgress progress = LightProgress.NONE;
        private volatile boolean isCancelled;

        Job(PlacedLevel placed, boolean isBake, Vec3 near, BakedLight former) {
            this.placed = placed;
            this.isBake = isBake;
            this.near = near;
            this.former = former;
            latest = former;
        }

        void begin() {
            done = CompletableFuture.supplyAsync(this::found, work.soon()).thenCompose(this::further);
            done.whenComplete((nothing, failed) -> work.repaintSoon().run());
        }

        boolean isDone() {
            return done.isDone();
        }

        void cancel() {
            isCancelled = true;
        }

        private void requireWanted() {
            if (isCancelled) {
                throw new CancellationException("the level has changed");
            }
        }

        /** Reads light, or bakes a sky's visibility; light that bounces stays until there is other. */
        private BakedLight found() {
            BakedLight found = LevelLight.of(placed, fraction -> requireWanted(), there -> stored = there);
            boolean bounces = former != null && former.indirect() != null;
            boolean isFound = found != null && found.indirect() != null;
            if (isFound || !bounces || !isBake) {
                latest = found;
            }
            return found;
        }

        private CompletableFuture<Void> further(BakedLight found) {
            boolean isEnough = found != null && found.indirect() != null;
            if (isEnough || !isBake || isCancelled || !LightRequirements.hasSurfaces(placed.level())) {
                return CompletableFuture.completedFuture(null);
            }
            progress = new LightProgress(Stage.COARSE, 0, 0);
            work.repaintSoon().run();
            return CompletableFuture.runAsync(() -> bake(found), work.baking());
        }

        private void bake(BakedLight found) {
            SwingThread.refuse("a bake of light");
            try {
                requireWanted();
                LightBake bake = LightBake.of(placed, LightBake.Settings.USUAL);
                BakedLight sky = LevelLight.of(placed, found == null ? null : found.visibility(), null);
                long began = System.nanoTime();
                bake.balance(fraction -> progress(LightProgress.since(began, Stage.COARSE, fraction)));
                show(sky, bake.light());
                int[] order = bake.blocksFrom(near);
                long beganFine = System.nanoTime();
                bake.gather(order, LightBake.Checkpoint.NONE, fraction -> {
                    progress(LightProgress.since(beganFine, Stage.FINE, fraction));
                    if (isToBeShown(fraction)) {
                        show(sky, bake.light());
                    }
                });
                IndirectLight fine = bake.light();
                show(sky, fine);
                LightCache.of(placed.assets()).store(LightKey.of(placed).fileName(), StoredLight.file(placed, fine));
            } catch (CancellationException cancelled) {
                return;
            } catch (RuntimeException | OutOfMemoryError failed) {
                failure = "baked light: " + failed.getMessage();
            } finally {
                progress = LightProgress.NONE;
            }
        }

        private void show(BakedLight sky, IndirectLight indirect) {
            requireWanted();
            latest = new BakedLight(sky.visibility(), indirect);
            work.repaintSoon().run();
        }

        private synchronized boolean isToBeShown(double fraction) {
            boolean isNow = fraction >= shownAt && shownAt < 1;
            shownAt *= isNow ? 2 : 1;
            return isNow;
        }

        /** Called after each receiver, perhaps by several threads. */
        private void progress(LightProgress now) {
            requireWanted();
            progress = now;
            int whole = (int) (100 * now.fraction());
            if (whole != percent) {
                percent = whole;
                work.repaintSoon().run();
            }
        }
    }
}
