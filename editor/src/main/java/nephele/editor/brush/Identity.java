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
        if (solid instanceof Solid.Box b) {
            return new Solid.Box(id, s.material(), s.portalable(), s.textureMapping(), b.centre(), b.size(), b.faces());
        } else if (solid instanceof Solid.Wedge w) {
            return new Solid.Wedge(
                    id, s.material(), s.portalable(), s.textureMapping(), w.centre(), w.size(), w.rising(), w.faces());
        } else if (solid instanceof Solid.Prism p) {
            return new Solid.Prism(
                    id,
                    s.material(),
                    s.portalable(),
                    s.textureMapping(),
                    p.centre(),
                    p.radiusMetres(),
                    p.heightMetres(),
                    p.sides(),
                    p.faces());
        } else if (solid instanceof Solid.Planes p) {
            return new Solid.Planes(id, s.material(), s.portalable(), s.textureMapping(), p.planes());
        }
        throw new IllegalArgumentException("no copy of " + solid.getClass().getSimpleName());
    }
}
