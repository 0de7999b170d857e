package nephele.engine.render;

import nephele.engine.math.Frustum;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.VisibleSet;
import nephele.engine.scene.dynamic.CharacterPresence;

/** What the caller, not the level, decides about a picture. */
public record RenderSettings(
        Output output,
        Quality quality,
        Culling culling,
        Narrowing narrowing,
        Decoration decoration,
        Deepest deepest,
        CharacterPresence figure) {
    /** How solids outside of a view are left out; pictures do not differ. */
    public enum Culling {
        /** Everything is drawn. */
        NONE,
        /** A sphere around each solid, one after the other. */
        SPHERE,
        /** Boxes around solids, and around more and more of them. */
        HIERARCHY;

        void find(VisibleSet visible, View view) {
            switch (this) {
                case NONE -> visible.selectAll();
                case SPHERE -> visible.findBySpheres(view);
                case HIERARCHY -> visible.find(view);
            }
        }

        void find(VisibleSet visible, Frustum frustum) {
            switch (this) {
                case NONE -> visible.selectAll();
                case SPHERE -> visible.findBySpheres(frustum);
                case HIERARCHY -> visible.find(frustum);
            }
        }
    }

    /** Whether a view through a portal is drawn only where the portal shows; pictures do not differ. */
    public enum Narrowing {
        ON,
        OFF
    }

    /** Whether what only guides the player is drawn: rims of portals, where a shot would land. */
    public enum Decoration {
        ON,
        OFF
    }

    /** What fills the openings that the view budget does not reach. */
    public enum Deepest {
        /** The picture before this one; where there is none, a membrane before the wall that the opening lies in. */
        HISTORY,
        /** A colour that nothing else has, see {@code Renderer.MARK}. */
        MARK
    }

    /** What of things that move a view may see; {@code null} for all in the sides of its picture. */
    Frustum limits(ViewNode node) {
        if (culling == Culling.NONE) {
            return Frustum.everything();
        }
        return node == null || node.parent() == null || narrowing == Narrowing.OFF ? null : node.frustum();
    }

    public static RenderSettings of(Output output) {
        return of(output, Quality.HIGH);
    }

    public static RenderSettings of(Output output, Quality quality) {
        return new RenderSettings(
                output,
                quality,
                Culling.HIERARCHY,
                Narrowing.ON,
                Decoration.ON,
                Deepest.HISTORY,
                CharacterPresence.NEVER);
    }

    public RenderSettings with(Quality newQuality) {
        return new RenderSettings(output, newQuality, culling, narrowing, decoration, deepest, figure);
    }

    public RenderSettings with(Culling newCulling) {
        return new RenderSettings(output, quality, newCulling, narrowing, decoration, deepest, figure);
    }

    public RenderSettings with(Narrowing newNarrowing) {
        return new RenderSettings(output, quality, culling, newNarrowing, decoration, deepest, figure);
    }

    public RenderSettings with(Decoration newDecoration) {
        return new RenderSettings(output, quality, culling, narrowing, newDecoration, deepest, figure);
    }

    public RenderSettings with(Deepest newDeepest) {
        return new RenderSettings(output, quality, culling, narrowing, decoration, newDeepest, figure);
    }

    public RenderSettings with(CharacterPresence newCharacter) {
        return new RenderSettings(output, quality, culling, narrowing, decoration, deepest, newCharacter);
    }
}
