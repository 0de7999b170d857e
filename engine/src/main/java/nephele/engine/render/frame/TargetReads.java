package nephele.engine.render.frame;

import java.util.List;
import java.util.Set;

/** Targets that a pass reads: the same value is what it declares and what it binds. */
public record TargetReads(List<Target> targets) {
    public TargetReads {
        targets = List.copyOf(targets);
    }

    public static TargetReads of(Target... targets) {
        return new TargetReads(List.of(targets));
    }

    /** As {@link Pass#reads} tells. */
    public Set<Target> declared() {
        return Set.copyOf(targets);
    }

    /** Binds what earlier passes have published, each to its unit. */
    public void bind(SharedResources shared) {
        for (int i = 0; i < targets.size(); i++) {
            Target target = targets.get(i);
            shared.texture(target).bind(target.unit());
        }
    }
}
