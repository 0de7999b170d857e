package nephele.engine.render;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Target;

/**
 * A pass that records the targets that another one binds while drawing; nested views do not count for the outer one.
 */
final class WatchedPass implements Pass {
    private final String name;
    private final Pass pass;
    private final BoundTargets targets;
    private final Set<Target> bound = EnumSet.noneOf(Target.class);

    private WatchedPass(String name, Pass pass, BoundTargets targets) {
        this.name = name;
        this.pass = pass;
        this.targets = targets;
    }

    /** Returns the same feature, whose passes are added to {@code built}. */
    static RenderFeature watch(RenderFeature feature, BoundTargets targets, List<WatchedPass> built) {
        return new RenderFeature(
                feature.name(),
                feature.stage(),
                feature.role(),
                feature.uses(),
                request -> feature.requiredBy().apply(request).stream()
                        .map(required -> new Required(required.because(), context -> {
                            WatchedPass watched = new WatchedPass(
                                    feature.name(), required.build().apply(context), targets);
                            built.add(watched);
                            return watched;
                        }))
                        .toList());
    }

    Set<Target> bound() {
        return bound;
    }

    @Override
    public void draw(FrameContext frame) {
        targets.mark();
        pass.draw(frame);
        bound.addAll(targets.boundSinceMark());
        targets.mark();
    }

    @Override
    public Set<Target> reads() {
        return pass.reads();
    }

    @Override
    public Set<Target> writes() {
        return pass.writes();
    }

    @Override
    public String toString() {
        return name;
    }
}
