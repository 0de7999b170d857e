package nephele.engine.render.frame;

import java.util.List;
import java.util.Set;
import java.util.function.Function;

/**
 * A feature that can be drawn; the one constant of the pass that draws it.
 *
 * @param uses the shared resources that the pass may ask for
 * @param requiredBy returns why a request needs it; empty if it does not
 */
public record RenderFeature(
        String name,
        Stage stage,
        Role role,
        Set<SharedResource<?>> uses,
        Function<FrameRequest, List<Required>> requiredBy) {

    /** The role of a pass that other code must distinguish. */
    public enum Role {
        SCENERY,
        /** The background, visible where no surface is. */
        SKY,
        /** An aid for the player, left out of pictures for comparison. */
        DECORATION
    }

    public RenderFeature(String name, Stage stage, Function<FrameRequest, List<Required>> requiredBy) {
        this(name, stage, Role.SCENERY, requiredBy);
    }

    public RenderFeature(String name, Stage stage, Role role, Function<FrameRequest, List<Required>> requiredBy) {
        this(name, stage, role, Set.of(), requiredBy);
    }

    /** Returns this feature with a pass that uses these shared resources. */
    public RenderFeature using(SharedResource<?>... resources) {
        return new RenderFeature(name, stage, role, Set.of(resources), requiredBy);
    }
}
