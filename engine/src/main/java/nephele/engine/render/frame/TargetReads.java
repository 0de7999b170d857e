package nephele.engine.render.frame;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import nephele.engine.render.gl.Texture;

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

    public boolean has(Target target) {
        return targets.contains(target);
    }

    /** Returns the targets for {@link Pass#reads}. */
    public Set<Target> declared() {
        return Set.copyOf(targets);
    }

    /** Binds the textures of these targets, each to its unit. */
    public void bind(Map<Target, Texture> written) {
        for (int i = 0; i < targets.size(); i++) {
            Target target = targets.get(i);
            Texture texture = written.get(target);
            if (texture == null) {
                throw new IllegalStateException(target + " is read, but no pass has written it");
            }
            texture.bind(target.unit());
        }
    }
}
