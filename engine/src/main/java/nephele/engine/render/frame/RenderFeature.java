package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;

/**
 * Something that can be drawn, as the one constant of the pass that draws it.
 *
 * @param requiredBy why a request needs it; empty when it does not
 */
public record RenderFeature(String name, Stage stage, Role role, Function<FrameRequest, List<Required>> requiredBy) {
    /** What a pass is for, where others must know. */
    public enum Role {
        SCENERY,
        /** What is seen where nothing else is. */
        SKY,
        /** Only guides the player: it can be left out of a picture that is compared with something. */
        DECORATION
    }

    public RenderFeature(String name, Stage stage, Function<FrameRequest, List<Required>> requiredBy) {
        this(name, stage, Role.SCENERY, requiredBy);
    }
}
