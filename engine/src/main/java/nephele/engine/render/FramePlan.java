package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;

/** The passes that a request requires, in frame order, with the reasons. */
public record FramePlan(List<Step> steps) {
    /** A registered feature; {@code required} is empty if nothing requires it. */
    public record Step(RenderFeature feature, List<Required> required) {}

    /** Returns the plan of a request for all registered features. */
    public static FramePlan of(FrameRequest request) {
        return of(request, RenderFeatures.ALL);
    }

    /** Returns the plan for a list of features other than the registered ones. */
    static FramePlan of(FrameRequest request, List<RenderFeature> features) {
        List<Step> steps = new ArrayList<>();
        for (RenderFeature feature : features) {
            steps.add(new Step(feature, feature.requiredBy().apply(request)));
        }
        return new FramePlan(List.copyOf(steps));
    }

    /** Returns the requirements that build the frame's passes, in order. */
    public List<Required> required() {
        return steps.stream().flatMap(step -> step.required().stream()).toList();
    }

    /**
     * Returns {@code NAME: required by JSON.PATH: because} or {@code NAME: not required}, at least one line for each
     * feature.
     */
    public List<String> explain() {
        return steps.stream().flatMap(step -> lines(step).stream()).toList();
    }

    private static List<String> lines(Step step) {
        String name = step.feature().name();
        return step.required().isEmpty()
                ? List.of(name + ": not required")
                : step.required().stream()
                        .map(required -> name + ": required by " + required.because())
                        .toList();
    }
}
