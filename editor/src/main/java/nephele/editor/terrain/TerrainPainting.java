package nephele.editor.terrain;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import nephele.editor.document.Document;
import nephele.editor.document.Snapshot;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.HeightMap;
import nephele.engine.asset.HeightMapFile;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;

/** Strokes on the terrains of a document: a drag that shows the heights so far, and one step at its end. */
public final class TerrainPainting {
    private static final String SECTION = "terrains";

    private final Document document;
    private final PaintedMaps maps;
    /** What the stroke goes on; {@code null} without one. */
    private Terrain painted;

    private TerrainBrush brush;
    private HeightMap before;
    private HeightStroke stroke;

    public TerrainPainting(Document document, PaintedMaps maps) {
        this.document = document;
        this.maps = maps;
    }

    /** Returns the world y of a place on the heights of the stroke; empty without one. */
    public OptionalDouble y(double x, double z) {
        return painted == null
                ? OptionalDouble.empty()
                : OptionalDouble.of(painted.centre().y() + stroke.heightMetres(x, z));
    }

    /**
     * Begins a stroke with its first dab.
     *
     * @throws TerrainRefusal if the terrain cannot be painted; nothing has changed then
     */
    public void begin(Terrain said, AssetSource assets, TerrainBrush with, double x, double z) throws TerrainRefusal {
        if (document.level().editor().locked().contains(SECTION + "/" + said.id())) {
            throw new TerrainRefusal(TerrainText.LOCKED.with(said.id()));
        }
        if (!maps.canKeep()) {
            throw new TerrainRefusal(TerrainText.SAVE_FIRST.words());
        }
        if (said.heightRangeMetres().low() == said.heightRangeMetres().high()) {
            throw new TerrainRefusal(TerrainText.NO_RANGE.with(said.id()));
        }
        try {
            before = assets.decoded(said.heightMap(), HeightMap.class, HeightMapFile::read);
        } catch (AssetException unusable) {
            throw new TerrainRefusal(TerrainText.UNUSABLE.with(unusable.getMessage()));
        }
        brush = with;
        painted = said;
        stroke = new HeightStroke(said, before, with, x, z);
        show();
    }

    /** Goes on to a place; does nothing without a stroke. */
    public void to(double x, double z) {
        if (painted != null) {
            stroke.to(x, z);
            show();
        }
    }

    private void show() {
        HeightMap now = stroke.map();
        if (now != before) {
            String id = maps.show(now);
            document.drag(start -> withMap(start, id));
        }
    }

    private Snapshot withMap(Snapshot start, String id) {
        EntityRef ref = new EntityRef(SECTION, painted.id());
        return start.with((Level)
                document.entities().changed(start.level(), List.of(ref), said -> ((Terrain) said).withHeightMap(id)));
    }

    /**
     * Makes the stroke one step; one that has changed no height makes none.
     *
     * @throws TerrainRefusal if its map cannot be kept; the level is then as before
     */
    public void end() throws TerrainRefusal {
        if (painted == null) {
            return;
        }
        try {
            if (Arrays.equals(before.values(), stroke.map().values())) {
                document.cancelDrag();
            } else {
                String id = maps.keep(painted.id(), stroke.map());
                document.drag(start -> withMap(start, id));
                document.commitDrag(brush.effect().title());
            }
        } catch (IOException problem) {
            document.cancelDrag();
            throw new TerrainRefusal(TerrainText.NOT_KEPT.with(problem.getMessage()));
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
        before = null;
    }

    /** Returns what the user should know of the stroke; empty for nothing. */
    public Optional<Words> notice() {
        if (painted == null || !stroke.isAtLimit()) {
            return Optional.empty();
        }
        Terrain.HeightRange range = painted.heightRangeMetres();
        return Optional.of(TerrainText.AT_LIMIT.with(
                NumberWords.of(Math.min(range.low(), range.high())),
                NumberWords.of(Math.max(range.low(), range.high()))));
    }
}
