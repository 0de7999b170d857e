package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Target;

/** The passes that a level requires: first what all views use, then a view's surfaces, then what reads their pixels. */
final class PassOrder implements AutoCloseable {
    private final List<Pass> passes = new ArrayList<>();
    private final List<String> stepNames = new ArrayList<>();
    private int surfacesBegin;
    private int surfacesEnd;

    void load(LoadContext context, RenderSettings settings, List<RenderFeature> features) {
        var plan = FramePlan.forLevel(context.scene().level(), settings.output(), settings.figure(), features);
        for (FramePlan.Step step : plan.steps()) {
            for (Required required : step.required()) {
                Pass pass = required.build().apply(context.gl());
                if (settings.decoration() == Decoration.ON || !pass.isDecoration()) {
                    passes.add(pass);
                    stepNames.add(step.feature().name());
                    pass.load(context);
                }
            }
        }
        while (surfacesEnd < passes.size() && !passes.get(surfacesEnd).reads().contains(Target.SURFACE)) {
            surfacesEnd++;
        }
        while (surfacesBegin < surfacesEnd && !passes.get(surfacesBegin).inEveryView()) {
            surfacesBegin++;
        }
        stepNames.add(surfacesBegin, "clear");
    }

    boolean isEmpty() {
        return passes.isEmpty();
    }

    int size() {
        return passes.size();
    }

    Pass get(int index) {
        return passes.get(index);
    }

    /** Index of the first pass that draws a view; those before it serve every view. */
    int surfacesBegin() {
        return surfacesBegin;
    }

    /** Index of the first pass that reads the surface's pixels. */
    int surfacesEnd() {
        return surfacesEnd;
    }

    /** Of the passes, with the clear between what serves every view and what draws one. */
    List<String> stepNames() {
        return List.copyOf(stepNames);
    }

    List<Pass> inEveryView() {
        return passes.stream().filter(Pass::inEveryView).toList();
    }

    @Override
    public void close() {
        passes.forEach(Pass::close);
    }
}
