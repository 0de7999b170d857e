package nephele.engine.render.fixed;

import java.util.EnumSet;
import java.util.Set;

/** How a scene is shown. */
public record SceneLook(Shading shading, Set<LightTerm> terms, Axes axes, Culling culling) {
    /** As a viewer starts. */
    public static final SceneLook USUAL =
            new SceneLook(Shading.GOURAUD, EnumSet.allOf(LightTerm.class), Axes.HIDDEN, Culling.SPHERES);

    /** Lines across the picture along x in red, y in green and z in blue. */
    public enum Axes {
        HIDDEN,
        SHOWN
    }

    /** Which models are submitted. */
    public enum Culling {
        /** All. */
        OFF,
        /** Those whose bounding sphere touches what the view can see. */
        SPHERES
    }

    public SceneLook {
        terms = Set.copyOf(terms);
    }

    public SceneLook with(Shading newShading) {
        return new SceneLook(newShading, terms, axes, culling);
    }

    public SceneLook with(Set<LightTerm> newTerms) {
        return new SceneLook(shading, newTerms, axes, culling);
    }

    public SceneLook with(Axes newAxes) {
        return new SceneLook(shading, terms, newAxes, culling);
    }

    public SceneLook with(Culling newCulling) {
        return new SceneLook(shading, terms, axes, newCulling);
    }

    float term(LightTerm term) {
        return terms.contains(term) ? 1 : 0;
    }
}
