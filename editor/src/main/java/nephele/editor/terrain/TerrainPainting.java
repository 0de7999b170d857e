package nephele.editor.terrain;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import nephele.editor.document.BackgroundReading;
import nephele.editor.document.Document;
import nephele.editor.document.Snapshot;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.HeightMap;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Terrain;
import nephele.engine.level.terrain.LayerPaint;

/** Strokes on the terrains of a document: a drag that shows the map so far, and one step at its end. */
public final class TerrainPainting {
    private static final String SECTION = "terrains";

    private final Document document;
    private final PaintedMaps maps;
    private final BackgroundReading background;
    /** What the stroke goes on; {@code null} without one. */
    private Terrain painted;

    private TerrainBrush brush;
    private TerrainStroke stroke;

    /** @param background runs what reads files */
    public TerrainPainting(Document document, PaintedMaps maps, BackgroundReading background) {
        this.document = document;
        this.maps = maps;
        this.background = background;
    }

    /** Returns the world y of a place on the heights of the stroke; empty without one that changes heights. */
    public OptionalDouble y(double x, double z) {
        return painted == null ? OptionalDouble.empty() : y(painted.centre().y(), stroke.height(x, z));
    }

    private static OptionalDouble y(double centre, OptionalDouble height) {
        return height.isPresent() ? OptionalDouble.of(centre + height.getAsDouble()) : height;
    }

    /**
     * Begins a stroke with its first dab.
     *
     * @throws EditorRefusal if the terrain cannot be painted; nothing has changed then
     */
    public void begin(Terrain authored, AssetSource assets, TerrainBrush with, double x, double z)
            throws EditorRefusal {
        if (document.level().editor().locked().contains(SECTION + "/" + authored.id())) {
            throw new EditorRefusal(TerrainText.LOCKED.with(authored.id()));
        }
        if (!maps.canKeep()) {
            throw new EditorRefusal(TerrainText.SAVE_FIRST.words());
        }
        stroke = background.get(() -> stroke(authored, assets, with, x, z));
        brush = with;
        painted = authored;
        show();
    }

    private static TerrainStroke stroke(Terrain authored, AssetSource assets, TerrainBrush with, double x, double z)
            throws EditorRefusal {
        try {
            return with.effect().isPaint() ? paint(authored, assets, with, x, z) : shape(authored, assets, with, x, z);
        } catch (AssetException unusable) {
            throw new EditorRefusal(TerrainText.UNUSABLE.with(unusable.getMessage()));
        }
    }

    private static TerrainStroke shape(Terrain authored, AssetSource assets, TerrainBrush with, double x, double z)
            throws EditorRefusal {
        if (authored.heightRangeMetres().low() == authored.heightRangeMetres().high()) {
            throw new EditorRefusal(TerrainText.NO_RANGE.with(authored.id()));
        }
        return new HeightStroke(authored, heights(authored, assets), with, x, z);
    }

    private static HeightMap heights(Terrain authored, AssetSource assets) {
        return assets.decoded(authored.heightMap(), HeightMap.class, HeightMap::read);
    }

    private static TerrainStroke paint(Terrain authored, AssetSource assets, TerrainBrush with, double x, double z)
            throws EditorRefusal {
        if (authored.layers().size() < 2) {
            throw new EditorRefusal(TerrainText.FEW_LAYERS.with(authored.id()));
        }
        if (with.effect() == Effect.PAINT && with.layer() >= authored.layers().size()) {
            throw new EditorRefusal(TerrainText.NO_LAYER.with(authored.id(), with.layer()));
        }
        Optional<LayerMap> before = LayerPaint.read(authored, assets);
        return new LayerStroke(authored, before.orElseGet(() -> blank(heights(authored, assets))), with, x, z);
    }

    /** Returns the map of a terrain that was never painted: a texel for each sample of the heights. */
    private static LayerMap blank(HeightMap heights) {
        return LayerMap.blank(heights.columns(), heights.rows());
    }

    /** Goes on to a place; does nothing without a stroke. */
    public void to(double x, double z) {
        if (painted != null) {
            stroke.to(x, z);
            show();
        }
    }

    private void show() {
        if (stroke.isTouched()) {
            String id = maps.show(stroke.painted());
            document.drag(start -> withMap(start, id));
        }
    }

    private Snapshot withMap(Snapshot start, String id) {
        EntityRef ref = new EntityRef(SECTION, painted.id());
        return start.with(
                Entities.LEVEL.changed(start.level(), List.of(ref), authored -> stroke.on((Terrain) authored, id)));
    }

    /**
     * Makes the stroke one step; one that has changed nothing makes none.
     *
     * @return the reason why it has changed nothing, empty if it has or if there is none to tell
     * @throws EditorRefusal if its map cannot be kept; the level is then as before
     */
    public Optional<Words> end() throws EditorRefusal {
        if (painted == null) {
            return Optional.empty();
        }
        try {
            if (!stroke.isChange()) {
                document.cancelDrag();
                return stroke.objection();
            }
            String id = maps.keep(stroke.name(painted), stroke.painted());
            document.drag(start -> withMap(start, id));
            document.commitDrag(brush.effect().title());
            return Optional.empty();
        } catch (IOException problem) {
            document.cancelDrag();
            throw new EditorRefusal(TerrainText.NOT_KEPT.with(problem.getMessage()));
        } finally {
            forget();
        }
    }

    /** Takes the stroke back. */
    public void cancel() {
        if (painted != null) {
            document.cancelDrag();
            forget();
        }
    }

    private void forget() {
        painted = null;
        stroke = null;
    }

    /** Returns what the user should know of the stroke; empty for nothing. */
    public Optional<Words> notice() {
        return painted == null ? Optional.empty() : stroke.notice();
    }
}
