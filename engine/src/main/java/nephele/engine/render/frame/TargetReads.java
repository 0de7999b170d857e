package nephele.engine.render.frame;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** The targets that a pass reads; the same value declares and binds them. */
public record TargetReads(List<Target> targets) {
    public TargetReads {
        targets = List.copyOf(targets);
    }

    public static TargetReads of(Target... targets) {
        return new TargetReads(List.of(targets));
    }

    /** Returns these targets and another one. */
    public TargetReads and(Target other) {
        return new TargetReads(Stream.concat(targets.stream(), Stream.of(other)).toList());
    }

    /** Returns the targets for {@link Pass#reads}. */
    public Set<Target> declared() {
        return Set.copyOf(targets);
    }

    /** Binds the published textures, each to its unit. */
    public void bind(SharedResources shared) {
        for (int i = 0; i < targets.size(); i++) {
            Target target = targets.get(i);
            shared.texture(target).bind(target.unit());
        }
    }
}
