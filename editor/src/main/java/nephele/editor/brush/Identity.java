package nephele.editor.brush;

import nephele.engine.level.Solid;

/** Copies of a solid that differ in what they are called and in the defaults of their faces. */
final class Identity {
    private Identity() {}

    static Solid withId(Solid solid, String id) {
        return with(solid, id, BrushStyle.of(solid));
    }

    /** Returns the solid with another id and other properties; what its faces say stays. */
    static Solid with(Solid solid, String id, BrushStyle s) {
        return solid.with(id, s.material(), s.portalable(), s.textureMapping());
    }
}
