package nephele.editor.tool;

import java.util.EnumSet;
import java.util.Set;
import nephele.editor.brush.BrushStyle;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.terrain.TerrainBrush;
import nephele.engine.level.Level;
import nephele.engine.level.TextureMapping;

/** The options of the tools: shape, material, kind of entity, snapping. Owned by the session and changed by its thread. */
public final class ToolOptions {
    /** A target of snapping; if none is set, places do not snap. */
    public enum Snapping {
        /** Lengths and displacements are multiples of the grid's step. */
        GRID,
        /** A vertex of a brush that is near the pointer is taken, before all others. */
        VERTEX,
        /** A moved thing rests on the surface under the pointer; a place is on it, in a plan on the nearest edge. */
        SURFACE,
        /** A moved thing comes to lie on the grid, even if it lay beside it. */
        ABSOLUTE
    }

    private final Set<Snapping> snapping = EnumSet.of(Snapping.GRID);
    private ShapeOptions shape = new ShapeOptions.Box();
    private String material;
    private boolean portalable = true;
    private String section = "bodies";
    private String kind = "box";
    private boolean textureLocked = true;
    private TerrainBrush terrainBrush = TerrainBrush.INITIAL;

    public Set<Snapping> snapping() {
        return snapping;
    }

    /** Returns the shape that the brush tool draws. */
    public ShapeOptions shape() {
        return shape;
    }

    public void shape(ShapeOptions next) {
        shape = next;
    }

    /** Returns the id of the material of new brushes and of the paint tool; {@code null} for grey. */
    public String material() {
        return material;
    }

    public void material(String id) {
        material = id;
    }

    /** Returns the style of new brushes in a level; a material that nobody knows any more is grey. */
    public BrushStyle style(Level level) {
        boolean isKnown = MaterialLibrary.STANDARD.find(level, material).isPresent();
        return new BrushStyle(isKnown ? material : null, portalable, TextureMapping.WORLD);
    }

    /** Returns true if new brushes take portals and the portalable tool sets, not clears. */
    public boolean isPortalable() {
        return portalable;
    }

    public void portalable(boolean next) {
        portalable = next;
    }

    /** Returns the section of the entity that the place tool makes, such as {@code lights}. */
    public String section() {
        return section;
    }

    /** Returns the kind of the entity that the place tool makes, such as {@code point}. */
    public String kind() {
        return kind;
    }

    public void entity(String newSection, String newKind) {
        section = newSection;
        kind = newKind;
    }

    /** Returns the brush of the terrain tool. */
    public TerrainBrush terrainBrush() {
        return terrainBrush;
    }

    public void terrainBrush(TerrainBrush next) {
        terrainBrush = next;
    }

    /** Returns true if textures stay fixed to a brush that moves. */
    public boolean isTextureLocked() {
        return textureLocked;
    }

    public void textureLocked(boolean next) {
        textureLocked = next;
    }
}
