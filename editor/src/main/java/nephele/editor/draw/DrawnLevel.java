package nephele.editor.draw;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.ViewMode;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.gl.GlContext;
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
    private final AirPreparation air;
    private final EditedLight light;
    private PlacedLevel placed;
    /** The level that was placed; the placed one may have the sun of its hour. */
    private Level placedFrom;

    private Level level;
    /** Without what is hidden, and in air that can be drawn at once. */
    private Level wanted;
    /** {@code null} if the last version could be derived. */
    private String levelFailure;

    private double elapsed;

    /** Creates an empty drawing. */
    DrawnLevel(GlContext gl, AssetSource assets, Background background, BackgroundWork work) {
        this.gl = gl;
        this.assets = assets;
        this.background = background;
        air = new AirPreparation(work.soon(), work.repaintSoon());
        light = new EditedLight(work);
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
        BakedLight baked = mode == ViewMode.LIT ? light.light() : null;
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

    /** Returns the light of the level, of which the last {@link #bake} was told. */
    EditedLight light() {
        return light;
    }

    /** Follows a version that stands for a while with what takes long. */
    void bake(boolean bakes, Vec3 eye) {
        light.follow(placed, bakes, eye);
    }

    /** Returns what is not drawn, a line each. */
    List<String> messages() {
        List<String> messages = new ArrayList<>(repair.messages(wanted));
        messages.addAll(failures.values());
        if (levelFailure != null) {
            messages.add(levelFailure);
        }
        messages.addAll(light.messages());
        return messages;
    }

    @Override
    public void close() {
        air.close();
        light.close();
        edges.values().forEach(LevelEdges::close);
        pictures.values().forEach(LevelPicture::close);
        pictures.clear();
    }
}
