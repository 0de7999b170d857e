package nephele.engine.render;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;

/** The passes that a request requires, in frame order: stage after stage. */
final class PassOrder implements AutoCloseable {
    private static final Set<Target> OF_A_VIEW = EnumSet.of(Target.VIEW_DEPTH, Target.VIEW_COLOUR);

    private final List<Pass> passes = new ArrayList<>();
    private final List<String> stepNames = new ArrayList<>();

    void load(LoadContext context, Decoration decoration, List<RenderFeature> features) {
        for (FramePlan.Step step : FramePlan.of(context.request(), features).steps()) {
            for (Required required : step.required()) {
                Pass pass = required.build().apply(context.gl());
                if (decoration == Decoration.ON || !pass.isDecoration()) {
                    add(pass, step.feature().name());
                    pass.load(context);
                }
            }
        }
        stepNames.add(begin(Stage.IN_VIEWS), "clear");
    }

    private void add(Pass pass, String name) {
        Stage stage = pass.stage();
        if (!passes.isEmpty() && passes.get(passes.size() - 1).stage().compareTo(stage) > 0) {
            pass.close();
            throw new IllegalStateException(
                    name + " is of stage " + stage + ", but stands after a pass of a later one");
        }
        if (stage != Stage.IN_VIEWS_AFTER_OPAQUE && pass.reads().stream().anyMatch(OF_A_VIEW::contains)) {
            pass.close();
            throw new IllegalStateException(name + " reads a copy of its view, but is of stage " + stage);
        }
        passes.add(pass);
        stepNames.add(name);
    }

    boolean isEmpty() {
        return passes.isEmpty();
    }

    /** Index of the first pass of {@code stage} or a later one. */
    private int begin(Stage stage) {
        return (int) passes.stream()
                .filter(pass -> pass.stage().compareTo(stage) < 0)
                .count();
    }

    List<Pass> of(Stage stage) {
        return passes.stream().filter(pass -> pass.stage() == stage).toList();
    }

    ViewPasses views() {
        int first = begin(Stage.IN_VIEWS);
        return new ViewPasses(
                List.copyOf(passes.subList(first, begin(Stage.AFTER_ALL))), begin(Stage.IN_VIEWS_AFTER_OPAQUE) - first);
    }

    /** Targets that any pass reads. */
    Set<Target> reads() {
        Set<Target> reads = EnumSet.noneOf(Target.class);
        passes.forEach(pass -> reads.addAll(pass.reads()));
        return reads;
    }

    /** Of the passes, with the clear between what serves every view and what draws one. */
    List<String> stepNames() {
        return List.copyOf(stepNames);
    }

    @Override
    public void close() {
        passes.forEach(Pass::close);
    }
}
