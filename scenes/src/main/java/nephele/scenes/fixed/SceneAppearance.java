package nephele.scenes.fixed;

import java.util.EnumSet;
import java.util.Set;

/**
 * The settings with which a scene is drawn.
 *
 * @param axes whether lines are drawn across the picture along x in red, y in green and z in blue
 */
public record SceneAppearance(Shading shading, Set<LightTerm> terms, boolean axes, Culling culling) {
    /** The settings at the start of a viewer. */
    public static final SceneAppearance USUAL =
            new SceneAppearance(Shading.GOURAUD, EnumSet.allOf(LightTerm.class), false, Culling.SPHERES);

    /** The choice of submitted models. */
    public enum Culling {
        /** All models. */
        OFF,
        /** Models whose bounding sphere intersects the view frustum. */
        SPHERES
    }

    public SceneAppearance {
        terms = Set.copyOf(terms);
    }

    /** Returns this appearance with another shading. */
    public SceneAppearance with(Shading newShading) {
        return new SceneAppearance(newShading, terms, axes, culling);
    }

    /** Returns this appearance with other light terms. */
    public SceneAppearance with(Set<LightTerm> newTerms) {
        return new SceneAppearance(shading, newTerms, axes, culling);
    }

    /** Returns this appearance with or without the axes. */
    public SceneAppearance withAxes(boolean drawn) {
        return new SceneAppearance(shading, terms, drawn, culling);
    }

    /** Returns this appearance with other culling. */
    public SceneAppearance with(Culling newCulling) {
        return new SceneAppearance(shading, terms, axes, newCulling);
    }

    float term(LightTerm term) {
        return terms.contains(term) ? 1 : 0;
    }
}
