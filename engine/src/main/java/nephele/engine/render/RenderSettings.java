package nephele.engine.render;

import java.util.List;
import nephele.engine.level.RecordCopy;
import nephele.engine.math.Frustum;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.QualityField;
import nephele.engine.render.frame.QualitySetting;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.VisibleSet;
import nephele.engine.scene.dynamic.CharacterPresence;

/** The properties of a picture that the caller decides, not the level. */
public record RenderSettings(
        Output output,
        Quality quality,
        @QualitySetting(
                        high = "hierarchy",
                        title = "Leaving out what is out of view",
                        about = "Solids that the view cannot show are not sent to the renderer: none left out, a"
                                + " sphere around each tested, or boxes around groups of them tested first."
                                + " Pictures must not differ.")
                Culling culling,
        @QualitySetting(
                        high = "on",
                        title = "Limits of views through portals",
                        about = "A view through a portal is limited to the portal's outline. Pictures must not differ.")
                Narrowing narrowing,
        @QualitySetting(
                        name = "rims",
                        high = "on",
                        title = "Rims of portals",
                        about = "Rims of portals and previews of shots: aids for the player, that a picture can go"
                                + " without.")
                Decoration decoration,
        Deepest deepest,
        CharacterPresence character) {
    /** The settings besides those of {@link Quality}, in the order of declaration. */
    public static final List<QualityField> FIELDS = QualityField.of(RenderSettings.class);

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

    /**
     * Returns settings with this output and quality, with decoration, without the character. Each frame is complete: none is
     * averaged with others, or drawn with fewer pixels for that. Use {@link #with(Quality)} for the quality as it is.
     */
    public static RenderSettings of(Output output, Quality quality) {
        return new RenderSettings(
                output,
                quality.inOneFrame(),
                Culling.HIERARCHY,
                Narrowing.ON,
                Decoration.ON,
                Deepest.HISTORY,
                CharacterPresence.NEVER);
    }

    /** Returns these settings with another quality. */
    public RenderSettings with(Quality newQuality) {
        return RecordCopy.with(this, "quality", newQuality);
    }

    /** Returns these settings with another method of culling. */
    public RenderSettings with(Culling newCulling) {
        return RecordCopy.with(this, "culling", newCulling);
    }

    /** Returns these settings with or without limits of views through portals. */
    public RenderSettings with(Narrowing newNarrowing) {
        return RecordCopy.with(this, "narrowing", newNarrowing);
    }

    /** Returns these settings with another decoration. */
    public RenderSettings with(Decoration newDecoration) {
        return RecordCopy.with(this, "decoration", newDecoration);
    }

    /** Returns these settings with another content of openings beyond the view budget. */
    public RenderSettings with(Deepest newDeepest) {
        return RecordCopy.with(this, "deepest", newDeepest);
    }

    /** Returns these settings with another presence of the player's character. */
    public RenderSettings with(CharacterPresence newCharacter) {
        return RecordCopy.with(this, "character", newCharacter);
    }

    /** Returns these settings with another value of a setting of quality or of {@link #FIELDS}. */
    public RenderSettings with(QualityField field, Object value) {
        return FIELDS.contains(field)
                ? RecordCopy.with(this, field.component(), value)
                : with(quality.with(field.component(), value));
    }
}
