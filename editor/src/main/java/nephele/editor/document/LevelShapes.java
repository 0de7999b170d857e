package nephele.editor.document;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;

/**
 * The brushes of a level's solids. An edited level's shapes reuse the brushes of unchanged records; a solid without a
 * volume has none.
 */
public final class LevelShapes {
    private final Map<Solid, Optional<Brush>> brushes;
    private final List<Brush> all;

    private LevelShapes(Map<Solid, Optional<Brush>> brushes, List<Brush> all) {
        this.brushes = brushes;
        this.all = all;
    }

    public static LevelShapes of(Level level) {
        return new LevelShapes(new IdentityHashMap<>(), List.of()).edited(level);
    }

    /** Returns the shapes of an edited level. */
    public LevelShapes edited(Level level) {
        Map<Solid, Optional<Brush>> next = new IdentityHashMap<>();
        List<Brush> present = new ArrayList<>();
        for (Solid solid : level.solids()) {
            Optional<Brush> known = brushes.get(solid);
            Optional<Brush> brush = known == null ? brushOf(solid) : known;
            next.put(solid, brush);
            brush.ifPresent(present::add);
        }
        return new LevelShapes(next, List.copyOf(present));
    }

    /** Returns the brush of any solid; empty if it has no volume. */
    public static Optional<Brush> brushOf(Solid solid) {
        try {
            return Optional.of(Brush.of(solid));
        } catch (IllegalArgumentException noVolume) {
            return Optional.empty();
        }
    }

    /** Returns the brushes in the order of the solids. */
    public List<Brush> brushes() {
        return all;
    }

    /** Returns the brush of one of the level's solids; empty if it has no volume. */
    public Optional<Brush> brush(Solid solid) {
        return brushes.getOrDefault(solid, Optional.empty());
    }
}
