package nephele.editor.draw;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.ViewMode;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.StoredLight;
import nephele.engine.scene.light.bake.BakedLight;

/** One document on the GPU, in the view modes that were used so far. What cannot be drawn is left out and reported. */
final class DrawnLevel implements AutoCloseable {
    private final GlContext gl;
    private final AssetSource assets;
    private final Background background;
    private final VisibleLevel visible = new VisibleLevel();
    private final LevelRepair repair = new LevelRepair();
    private final Map<ViewMode, LevelPicture> pictures = new EnumMap<>(ViewMode.class);
    private final Map<ViewMode, String> failures = new EnumMap<>(ViewMode.class);
    private final Map<PaneKind, LevelEdges> edges = new EnumMap<>(PaneKind.class);
    private final Executor executor;
    private final Runnable repaintSoon;
    private final AirPreparation air;
    private PlacedLevel placed;
    /** The level that was placed; the placed one may have the sun of its hour. */
    private Level placedFrom;

    private Level level;
    /** Without what is hidden, and in air that can be drawn at once. */
    private Level wanted;
    /** {@code null} if the last version could be derived. */
    private String levelFailure;

    private double elapsed;

    /** The shapes whose sky's light was baked last, or is. */
    private StaticShapes lit;
    /** {@code null} while no bake runs. */
    private CompletableFuture<BakedLight> bake;
    /** The last light that was ready; {@code null} for none. */
    private BakedLight light;

    /** Why baked light is not drawn; {@code null} if there is none, or it is. */
    private volatile String ignored;

    private volatile boolean isClosed;

    /**
     * Creates an empty drawing.
     *
     * @param repaintSoon called on a thread of {@code executor} when more than before is ready
     */
    DrawnLevel(GlContext gl, AssetSource assets, Background background, Executor executor, Runnable repaintSoon) {
        this.gl = gl;
        this.assets = assets;
        this.background = background;
        this.executor = executor;
        this.repaintSoon = repaintSoon;
        air = new AirPreparation(executor, repaintSoon);
    }

    /** Returns true if a level with these files and background is an edited version of this one. */
    boolean follows(AssetSource otherAssets, Background otherBackground) {
        return otherAssets == assets && otherBackground == background;
    }

    /** Lets time pass in which edits are taken over gradually, as {@link LevelPicture#elapse} does. */
    void elapse(double seconds) {
        elapsed = seconds;
        pictures.values().forEach(picture -> picture.elapse(seconds));
    }

    /** Returns how far the last edit is taken over in a mode, 1 for wholly. */
    double changed(ViewMode mode) {
        LevelPicture picture = pictures.get(mode);
        return picture == null ? 1 : picture.changed();
    }

    /** Follows an edit, and what was prepared in the background. */
    void show(Level level) {
        this.level = level;
        levelFailure = null;
        wanted = air.of(visible.of(level));
        while (true) {
            Level usable = repair.of(wanted);
            try {
                place(usable);
                return;
            } catch (RuntimeException failure) {
                if (!repair.learn(wanted, failure)) {
                    failure(failure);
                    return;
                }
            }
        }
    }

    /** Returns what of the last level is drawn as far as possible. */
    Level wanted() {
        return wanted;
    }

    /** Keeps the last level that could be derived. */
    private void failure(RuntimeException failure) {
        levelFailure = String.valueOf(failure.getMessage());
        if (placed == null) {
            place(Level.of("", "", level.environment(), List.of()));
        }
    }

    private void place(Level usable) {
        if (placed == null) {
            placed = PlacedLevel.of(usable, assets);
        } else if (placedFrom != usable) {
            placed = placed.edited(usable);
        }
        placedFrom = usable;
    }

    /** Returns what of the last level could be placed. */
    PlacedLevel placed() {
        return placed;
    }

    /** Returns the picture of a mode, or empty if it cannot be made; the reason is then among the messages. */
    Optional<LevelPicture> picture(ViewMode mode) {
        LevelPicture picture = pictures.computeIfAbsent(mode, this::begun);
        BakedLight baked = mode == ViewMode.LIT ? light() : null;
        failures.remove(mode);
        while (true) {
            try {
                picture.show(placed, baked);
                return Optional.of(picture);
            } catch (RuntimeException failure) {
                if (!repair.learn(wanted, failure)) {
                    failures.put(mode, mode + ": " + failure.getMessage());
                    return Optional.empty();
                }
                show(level);
            }
        }
    }

    private LevelPicture begun(ViewMode mode) {
        LevelPicture picture = new LevelPicture(gl, mode, background.radiance());
        picture.elapse(elapsed);
        return picture;
    }

    /** Returns the edges of all shapes, for a kind of pane. */
    LevelEdges edges(PaneKind kind) {
        LevelEdges all = edges.computeIfAbsent(kind, k -> new LevelEdges(gl, k));
        all.show(placed.statics());
        return all;
    }

    /** Returns the heights of all terrains. */
    List<HeightField> ground() {
        return placed.statics().ground().stream()
                .map(StaticShape.HeightGrid::field)
                .toList();
    }

    /** Returns the sky's light that the next picture would use, perhaps of an earlier version; {@code null} for none. */
    BakedLight light() {
        if (bake != null && bake.isDone()) {
            light = result(bake);
            bake = null;
        }
        return light;
    }

    /** Returns the earlier light if a bake fails: a picture with old light is better than none. */
    private BakedLight result(CompletableFuture<BakedLight> done) {
        try {
            return done.join();
        } catch (CompletionException | CancellationException failed) {
            return light;
        }
    }

    /**
     * Reads the light of this version in the background, if its shapes differ and nothing of the kind runs, and bakes that
     * of the sky if it has any.
     */
    void bake() {
        boolean isNew = placed.statics() != lit && (lit == null || LightRequirements.skyVisibility(placed.level()));
        if (isNew && bake == null) {
            lit = placed.statics();
            PlacedLevel baked = placed;
            bake = CompletableFuture.supplyAsync(() -> LevelLight.of(baked, this::progress, this::report), executor);
            bake.whenComplete((visibility, failure) -> repaintSoon.run());
        }
    }

    private void report(StoredLight stored) {
        String name =
                assets.levelFile().map(file -> file.getFileName().toString()).orElse("LEVEL");
        ignored = stored.warning(name).orElse(null);
    }

    private void progress(double done) {
        if (isClosed) {
            throw new CancellationException();
        }
    }

    /** Returns what is not drawn, a line each. */
    List<String> messages() {
        List<String> messages = new ArrayList<>(repair.messages(wanted));
        messages.addAll(failures.values());
        if (levelFailure != null) {
            messages.add(levelFailure);
        }
        String warning = ignored;
        if (warning != null) {
            messages.add(warning);
        }
        return messages;
    }

    @Override
    public void close() {
        isClosed = true;
        air.close();
        edges.values().forEach(LevelEdges::close);
        pictures.values().forEach(LevelPicture::close);
        pictures.clear();
    }
}
