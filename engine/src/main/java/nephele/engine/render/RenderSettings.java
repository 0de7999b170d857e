package nephele.engine.render;

import nephele.engine.math.Frustum;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.VisibleSet;
import nephele.engine.scene.dynamic.CharacterPresence;

/** The properties of a picture that the caller decides, not the level. */
public record RenderSettings(
        Output output,
        Quality quality,
        Culling culling,
        Narrowing narrowing,
        Decoration decoration,
        Deepest deepest,
        CharacterPresence character) {
    /** The method of culling solids outside a view; pictures do not differ. */
    public enum Culling {
        /** Draws everything. */
        NONE,
        /** Tests the bounding sphere of each solid. */
        SPHERE,
        /** Traverses the bounding volume hierarchy. */
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

    /** Decides whether a view through a portal is limited to the portal's outline; pictures do not differ. */
    public enum Narrowing {
        ON,
        OFF
    }

    /** Decides whether aids for the player are drawn: rims of portals and previews of shots. */
    public enum Decoration {
        ON,
        OFF
    }

    /** The content of the openings beyond the view budget. */
    public enum Deepest {
        /** The previous picture; without one, the sky of the view behind the opening and a membrane over it. */
        HISTORY,
        /** A colour that nothing else has, see {@code NestedViews.MARK}. */
        MARK
    }

    /** Returns the frustum for culling dynamic objects in a view; {@code null} for the frustum of its picture. */
    Frustum limits(ViewNode node) {
        if (culling == Culling.NONE) {
            return Frustum.everything();
        }
        return node == null || node.parent() == null || narrowing == Narrowing.OFF ? null : node.frustum();
    }

    /** Returns settings with quality HIGH. */
    public static RenderSettings of(Output output) {
        return of(output, Quality.HIGH);
    }

    /** Returns settings with this output and quality, with decoration, without the character. */
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
        return new RenderSettings(output, newQuality, culling, narrowing, decoration, deepest, character);
    }

    public RenderSettings with(Culling newCulling) {
        return new RenderSettings(output, quality, newCulling, narrowing, decoration, deepest, character);
    }

    public RenderSettings with(Narrowing newNarrowing) {
        return new RenderSettings(output, quality, culling, newNarrowing, decoration, deepest, character);
    }

    /** Returns these settings with another decoration. */
    public RenderSettings with(Decoration newDecoration) {
        return new RenderSettings(output, quality, culling, narrowing, newDecoration, deepest, character);
    }

    /** Returns these settings with another content of openings beyond the view budget. */
    public RenderSettings with(Deepest newDeepest) {
        return new RenderSettings(output, quality, culling, narrowing, decoration, newDeepest, character);
    }

    /** Returns these settings with another presence of the player's character. */
    public RenderSettings with(CharacterPresence newCharacter) {
        return new RenderSettings(output, quality, culling, narrowing, decoration, deepest, newCharacter);
    }
}
